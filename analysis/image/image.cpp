// SPDX-License-Identifier: MIT
#include "analysis/image/image.h"

#include <fmt/format.h>
#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "solver/core/errors.h"
#include "solver/io/atomic_file.h"

namespace bake {
namespace {

constexpr const char* k_letters = "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf";  ///< of fonts-liberation

vtkNew<vtkImageData> rendered(const std::string& text, int size) {
  vtkNew<vtkTextProperty> font;
  if (std::filesystem::exists(k_letters)) {
    font->SetFontFamily(VTK_FONT_FILE);
    font->SetFontFile(k_letters);
  } else {
    font->SetFontFamilyToArial();  // VTK's own, which has fewer letters
  }
  font->SetFontSize(std::max(4, static_cast<int>(std::lround(0.72 * size))));
  font->SetColor(1, 1, 1);
  vtkNew<vtkImageData> drawn;
  int extent[2];
  vtkFreeTypeTools* tools = vtkFreeTypeTools::GetInstance();
  tools->ScaleToPowerTwoOff();
  if (!tools->RenderString(font, text, 72, drawn, extent)) throw std::runtime_error(fmt::format("cannot draw the text '{}'", text));
  return drawn;
}

/// How much ink there is at a place, from 0 to 1.
double coverage(vtkImageData* drawn, int column, int row) {
  return static_cast<const unsigned char*>(drawn->GetScalarPointer(column, row, 0))[3] / 255.0;
}

/// Columns and rows of a drawn text; they need not start at 0.
struct Box {
  int left, right, bottom, top;  ///< the last two included, too
  explicit Box(vtkImageData* drawn) {
    const int* extent = drawn->GetExtent();
    left = extent[0], right = extent[1], bottom = extent[2], top = extent[3];
  }
};

/// The row amid those where a letter has ink.
int middle_row(vtkImageData* letter) {
  const Box box(letter);
  int first = box.top, last = box.bottom;
  for (int row = box.bottom; row <= box.top; ++row)
    for (int column = box.left; column <= box.right; ++column)
      if (coverage(letter, column, row) > 0.5) {
        first = std::min(first, row);
        last = std::max(last, row);
      }
  return (first + last) / 2;
}

}  // namespace

std::array<std::uint8_t, 3> pixel(const Colour& srgb) {
  std::array<std::uint8_t, 3> bytes;
  for (int c = 0; c < 3; ++c)
    bytes[static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(srgb[c], 0.0f, 1.0f)));
  return bytes;
}

Image::Image(int width, int height, const Colour& srgb)
    : width(width), height(height), pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), pixel(srgb)) {}

void paste(Image& image, const Image& part, int x, int y) {
  for (int row = std::max(0, -y); row < std::min(part.height, image.height - y); ++row)
    for (int column = std::max(0, -x); column < std::min(part.width, image.width - x); ++column)
      image.at(x + column, y + row) = part.at(column, row);
}

Image scaled(const Image& image, int width, int height) {
  Image result(width, height, Colour::Zero());
  const double step_x = static_cast<double>(image.width) / width, step_y = static_cast<double>(image.height) / height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double x0 = x * step_x, x1 = x0 + step_x, y0 = y * step_y, y1 = y0 + step_y;
      Eigen::Array3d sum = Eigen::Array3d::Zero();
      double area = 0;
      for (int v = static_cast<int>(y0); v < std::min<double>(image.height, y1); ++v)
        for (int u = static_cast<int>(x0); u < std::min<double>(image.width, x1); ++u) {
          const double share = (std::min(x1, u + 1.0) - std::max<double>(x0, u)) * (std::min(y1, v + 1.0) - std::max<double>(y0, v));
          const auto& p = image.at(u, v);
          sum += share * Eigen::Array3d(p[0], p[1], p[2]);
          area += share;
        }
      result.at(x, y) = pixel((sum / (255 * area)).cast<float>());
    }
  return result;
}

void draw_text(Image& image, const std::string& text, int x, int y, int size, Anchor anchor, const Colour& srgb) {
  if (text.empty()) return;
  const vtkNew<vtkImageData> drawn = rendered(text, size), letter = rendered("H", size);
  const Box box(drawn);
  const int middle = middle_row(letter), wide = box.right - box.left + 1;
  const int wanted = anchor == Anchor::left ? x : anchor == Anchor::right ? x - wide : x - wide / 2;
  const int margin = size / 4, start = std::max(margin, std::min(wanted, image.width - wide - margin));
  const auto colour = pixel(srgb);
  for (int row = box.bottom; row <= box.top; ++row) {  // from below; every text of one size has its baseline in the same row
    const int to_y = y + middle - row;
    for (int column = box.left; column <= box.right; ++column) {
      const int to_x = start + column - box.left;
      if (to_x < 0 || to_y < 0 || to_x >= image.width || to_y >= image.height) continue;
      const double cover = coverage(drawn, column, row);
      auto& under = image.at(to_x, to_y);
      for (std::size_t c = 0; c < 3; ++c) under[c] = static_cast<std::uint8_t>(std::lround(cover * colour[c] + (1 - cover) * under[c]));
    }
  }
}

namespace {

vtkNew<vtkImageData> vtk_image(const Image& image) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < image.height; ++y)
    std::copy_n(image.at(0, y).data(), 3 * image.width, static_cast<unsigned char*>(data->GetScalarPointer(0, image.height - 1 - y, 0)));
  return data;
}

/// Writes the file with a writer of VTK's that can write to memory.
template <class Writer>
void write_with(Writer& writer, const std::filesystem::path& path, const Image& image) {
  const vtkNew<vtkImageData> data = vtk_image(image);
  writer.SetInputData(data);
  writer.WriteToMemoryOn();
  writer.Write();
  vtkUnsignedCharArray* bytes = writer.GetResult();
  AtomicFile file(path);
  file.write_at(0, std::as_bytes(std::span(bytes->GetPointer(0), static_cast<std::size_t>(bytes->GetNumberOfValues()))));
  file.commit();
}

}  // namespace

void write_png(const std::filesystem::path& path, const Image& image) {
  const vtkNew<vtkPNGWriter> writer;
  write_with(*writer.Get(), path, image);
}

void write_jpeg(const std::filesystem::path& path, const Image& image, int quality) {
  const vtkNew<vtkJPEGWriter> writer;
  writer->SetQuality(quality);
  write_with(*writer.Get(), path, image);
}

Image read_png(const std::filesystem::path& path) {
  vtkNew<vtkPNGReader> reader;
  if (!std::filesystem::is_regular_file(path)) throw InputError(fmt::format("{}: no such file", path.string()));
  if (!reader->CanReadFile(path.c_str())) throw InputError(fmt::format("{}: not a picture, allowed: a PNG file", path.string()));
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* data = reader->GetOutput();
  const int channels = data->GetNumberOfScalarComponents();
  if (data->GetScalarType() != VTK_UNSIGNED_CHAR || channels < 3)
    throw InputError(fmt::format("{}: found a picture of another kind, allowed: colour with 8 bits a channel", path.string()));
  int* size = data->GetDimensions();
  Image image(size[0], size[1], Colour::Zero());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      std::copy_n(static_cast<const unsigned char*>(data->GetScalarPointer(x, image.height - 1 - y, 0)), 3, image.at(x, y).data());
  return image;
}

}  // namespace bake
