// SPDX-License-Identifier: MIT
// Images: drawing on them, reading and writing PNG, writing JPEG.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/image/colour.h"

namespace bake {

/// 8-bit sRGB, row by row from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 3>> pixels;

  Image() = default;
  Image(int width, int height, const Colour& srgb);
  std::array<std::uint8_t, 3>& at(int x, int y) {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
  const std::array<std::uint8_t, 3>& at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }
};

std::array<std::uint8_t, 3> pixel(const Colour& srgb);

/// Copies `part` so that its upper left corner is at (x, y); pixels outside this image are dropped.
void paste(Image& image, const Image& part, int x, int y);

/// The image at a smaller size; each pixel is the mean of the pixels that it covers.
Image scaled(const Image& image, int width, int height);

/// Where a text is anchored, horizontally; vertically it is always its middle.
enum class Anchor { left, centre, right };

/// Draws one line of text, `size` pixels high from descent to ascent, with its middle at y and its anchor at x, or as near to x as it must
/// be to lie within the image. ASCII: VTK leaves out other letters.
void draw_text(Image& image, const std::string& text, int x, int y, int size, Anchor anchor, const Colour& srgb);

/// Writes a PNG, completely or not at all; the same image gives the same bytes. Throws OutputError.
void write_png(const std::filesystem::path& path, const Image& image);

/// Writes a JPEG, completely or not at all; `quality` from 1 to 100. Throws OutputError.
void write_jpeg(const std::filesystem::path& path, const Image& image, int quality);

/// Throws InputError if the file is missing or not a PNG.
Image read_png(const std::filesystem::path& path);

}  // namespace bake
