// SPDX-License-Identifier: MIT
// Says whether two folders of object files hold the same machine code and constants, whatever their names, order and files.
// Usage: bake-same-code <folder> <folder>; exit code 0: the same, 1: not the same (with a list), 2: wrong use.
//
// Each function and each constant stands in a section of its own (-ffunction-sections -fdata-sections). Its own content is its bytes,
// and where they refer to something else. Two are equal if their own contents are and what they refer to is equal as well; this is
// refined from own contents outwards until no more are told apart, so that functions which call each other are compared, too. Names
// count only for what is defined nowhere here (std::sin).
//
// Objects in a subfolder `beside` need not be equal, and what calls them does not ask what they do; they are looked at to find what
// merely moved from there or to there.
//
// Left out: names of types (_ZTS...), tables for unwinding, how often a function was compiled, and the order of everything.
#include <cxxabi.h>
#include <elf.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

/// A function or a constant.
struct Part {
  struct Use {
    std::vector<std::size_t> parts;  // indices; several if a name has several definitions
    std::string else_name;           // what is no part: a name from outside, the content of a small constant
  };
  std::string name;
  bool is_code = false;
  bool is_beside = false;
  std::string own;
  std::vector<Use> uses;
  std::size_t own_color = 0;
  std::size_t color = 0;
};

std::size_t hash(const std::string& text) { return std::hash<std::string>{}(text); }

/// One object file as it lies in memory.
class Object {
 public:
  Object(const std::filesystem::path& file, bool is_beside) : is_beside(is_beside), name_(file.string()) {
    std::ifstream in(file, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(in), {});
    const auto& header = *at<Elf64_Ehdr>(0);
    if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 || header.e_ident[EI_CLASS] != ELFCLASS64 || header.e_type != ET_REL) damaged();
    sections_ = list<Elf64_Shdr>(header.e_shoff, header.e_shnum);
    section_names_ = sections_.at(header.e_shstrndx).sh_offset;
    for (const Elf64_Shdr& section : sections_) {
      if (section.sh_type != SHT_SYMTAB) continue;
      symbols_ = list<Elf64_Sym>(section.sh_offset, section.sh_size / sizeof(Elf64_Sym));
      symbol_names_ = sections_.at(section.sh_link).sh_offset;
    }
  }

  const bool is_beside;

  const std::vector<Elf64_Shdr>& sections() const { return sections_; }
  const std::vector<Elf64_Sym>& symbols() const { return symbols_; }
  std::string name(const Elf64_Shdr& section) const { return text(section_names_ + section.sh_name); }
  std::string name(const Elf64_Sym& symbol) const { return text(symbol_names_ + symbol.st_name); }
  std::string content(const Elf64_Shdr& s) const {
    return s.sh_type == SHT_NOBITS ? std::to_string(s.sh_size) + " zeros" : std::string(at<char>(s.sh_offset, s.sh_size), s.sh_size);
  }
  std::vector<Elf64_Rela> relocations(const Elf64_Shdr& s) const { return list<Elf64_Rela>(s.sh_offset, s.sh_size / sizeof(Elf64_Rela)); }

  /// A constant among those that the linker may merge: a string, or a number of fixed size.
  std::string merged(const Elf64_Shdr& section, std::size_t offset) const {
    const std::string all = content(section);
    if (offset > all.size()) damaged();
    return (section.sh_flags & SHF_STRINGS) != 0 && section.sh_entsize == 1 ? "\"" + std::string(all.c_str() + offset)
                                                                            : all.substr(offset, section.sh_entsize);
  }

 private:
  [[noreturn]] void damaged() const { throw std::runtime_error(name_ + ": found no object file, allowed: those of 64-bit ELF"); }

  template <class T>
  const T* at(std::size_t offset, std::size_t count = 1) const {
    if (offset > bytes_.size() || count > (bytes_.size() - offset) / sizeof(T)) damaged();
    return reinterpret_cast<const T*>(bytes_.data() + offset);
  }
  template <class T>
  std::vector<T> list(std::size_t offset, std::size_t count) const {
    return {at<T>(offset, count), at<T>(offset, count) + count};
  }
  std::string text(std::size_t offset) const { return at<char>(offset); }

  std::string name_;
  std::string bytes_;
  std::vector<Elf64_Shdr> sections_;
  std::vector<Elf64_Sym> symbols_;
  std::size_t section_names_ = 0, symbol_names_ = 0;
};

/// Whether a section is a part: it is loaded with the program, it is not for unwinding, its constants are not found by content.
bool is_part(const Object& object, const Elf64_Shdr& section) {
  return (section.sh_flags & SHF_ALLOC) != 0 && (section.sh_flags & SHF_MERGE) == 0 && section.sh_size > 0 && section.sh_type != SHT_NOTE &&
         object.name(section) != ".eh_frame";
}

std::string readable(const std::string& name) {
  char* text = abi::__cxa_demangle(name.c_str(), nullptr, nullptr, nullptr);
  std::string result = text != nullptr ? text : name;
  std::free(text);
  return result;
}

/// All parts of the objects below a folder.
class Side {
 public:
  Side(const std::filesystem::path& folder, std::vector<Part>& all) : all_(all), first_(all.size()) {
    std::vector<Object> objects;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (entry.path().extension() == ".o")
        objects.emplace_back(entry.path(), *entry.path().lexically_relative(folder).begin() == "beside");
    }
    for (const Object& object : objects) define(object);
    for (std::size_t i = 0; i < objects.size(); ++i) connect(objects[i], places_[i]);
    last_ = all_.size();
  }

  std::size_t first() const { return first_; }
  std::size_t last() const { return last_; }

 private:
  void define(const Object& object) {
    std::map<std::size_t, std::size_t>& place = places_.emplace_back();
    for (std::size_t i = 0; i < object.sections().size(); ++i) {
      const Elf64_Shdr& section = object.sections()[i];
      if (!is_part(object, section)) continue;
      const std::string name = object.name(section);
      const bool is_code = (section.sh_flags & SHF_EXECINSTR) != 0;
      const bool names_a_type = name.find("._ZTS") != name.npos;
      place[i] = all_.size();
      all_.push_back({name,
                      is_code,
                      object.is_beside,
                      std::to_string(section.sh_flags & ~SHF_GROUP) + (names_a_type ? "name" : object.content(section)),
                      {}});
    }
    for (const Elf64_Sym& symbol : object.symbols()) {
      if (!place.contains(symbol.st_shndx)) continue;
      const int type = ELF64_ST_TYPE(symbol.st_info);
      Part& part = all_[place[symbol.st_shndx]];
      if (symbol.st_value == 0 && (type == STT_FUNC || type == STT_OBJECT)) part.name = readable(object.name(symbol));
      if (ELF64_ST_BIND(symbol.st_info) != STB_LOCAL) defined_[object.name(symbol)].insert(place[symbol.st_shndx]);
    }
  }

  void connect(const Object& object, const std::map<std::size_t, std::size_t>& place) {
    for (const Elf64_Shdr& section : object.sections()) {
      if (section.sh_type != SHT_RELA || !place.contains(section.sh_info)) continue;
      Part& part = all_[place.at(section.sh_info)];
      for (const Elf64_Rela& relocation : object.relocations(section)) {
        part.uses.push_back({});
        part.own += std::to_string(relocation.r_offset) + ' ' + std::to_string(ELF64_R_TYPE(relocation.r_info)) + ' ' +
                    refer(object, place, relocation, part.uses.back()) + '\n';
      }
    }
  }

  /// Fills in what a relocation refers to; what is added to that is part of the own content, and returned.
  std::string refer(const Object& object, const std::map<std::size_t, std::size_t>& place, const Elf64_Rela& relocation,
                    Part::Use& use) const {
    const Elf64_Sym& symbol = object.symbols().at(ELF64_R_SYM(relocation.r_info));
    if (ELF64_ST_BIND(symbol.st_info) != STB_LOCAL) {
      const std::string name = object.name(symbol);
      const auto found = defined_.find(name);
      if (found != defined_.end()) {
        use.parts.assign(found->second.begin(), found->second.end());
      } else {
        use.else_name = "name " + name;
      }
      return std::to_string(relocation.r_addend);
    }
    if (place.contains(symbol.st_shndx)) {
      use.parts = {place.at(symbol.st_shndx)};
      return std::to_string(static_cast<std::int64_t>(symbol.st_value) + relocation.r_addend);
    }
    if (symbol.st_shndx == SHN_UNDEF || symbol.st_shndx >= object.sections().size()) return std::to_string(relocation.r_addend);
    const Elf64_Shdr& section = object.sections()[symbol.st_shndx];
    if ((section.sh_flags & SHF_MERGE) == 0) return std::to_string(relocation.r_addend);
    // The assembler names the section instead of the constant where nothing is added to the address; then the addend is the place in it.
    const bool of_section = ELF64_ST_TYPE(symbol.st_info) == STT_SECTION;
    const std::int64_t offset = of_section ? relocation.r_addend : static_cast<std::int64_t>(symbol.st_value);
    use.else_name = "constant " + object.merged(section, static_cast<std::size_t>(offset));
    return of_section ? "" : std::to_string(relocation.r_addend);
  }

  std::vector<Part>& all_;
  std::size_t first_, last_ = 0;
  std::vector<std::map<std::size_t, std::size_t>> places_;  // for each object: part of each section
  std::map<std::string, std::set<std::size_t>> defined_;
};

using Colors = std::set<std::size_t>;
const std::size_t k_beside = hash("beside");

/// Colors the parts so that two have the same color if and only if they are equal as described above; all that are beside are equal.
void color(std::vector<Part>& parts) {
  for (Part& part : parts) {
    std::string own = part.own;
    for (const Part::Use& use : part.uses) own += use.else_name + '\0';
    part.own_color = part.color = part.is_beside ? k_beside : hash(own);
  }
  for (std::size_t before = 0;;) {
    Colors different;
    for (const Part& part : parts) different.insert(part.color);
    if (different.size() == before) return;
    before = different.size();
    std::vector<std::size_t> next;
    for (const Part& part : parts) {
      std::string seen = std::to_string(part.own_color);
      for (const Part::Use& use : part.uses) {
        Colors colors;
        for (const std::size_t other : use.parts) colors.insert(parts[other].color);
        if (colors.size() > 1) colors.erase(k_beside);  // of a function that both rooms have compiled ours is compared
        for (const std::size_t other : colors) seen += ' ' + std::to_string(other);
        seen += ';';
      }
      next.push_back(part.is_beside ? part.own_color : hash(seen));
    }
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i].color = next[i];
  }
}

using Names = std::map<std::string, bool>;  // true: of a function, false: of a constant

/// The colors, or the own colors, of one side's parts that are not beside.
Colors colors_of(const std::vector<Part>& parts, const Side& side, std::size_t Part::*color) {
  Colors colors;
  for (std::size_t i = side.first(); i < side.last(); ++i) {
    if (!parts[i].is_beside) colors.insert(parts[i].*color);
  }
  return colors;
}

/// Parts that are beside on one side and not on the other have moved; they are compared as all others.
void find_moved(std::vector<Part>& parts, const Side& here, const Side& there) {
  std::vector<Part> all = parts;
  for (Part& part : all) part.is_beside = false;
  color(all);
  std::vector<std::size_t> moved;
  for (const auto& [one, other] : {std::pair(&here, &there), std::pair(&there, &here)}) {
    Colors known;
    for (std::size_t i = other->first(); i < other->last(); ++i) {
      if (!parts[i].is_beside) known.insert(all[i].color);
    }
    for (std::size_t i = one->first(); i < one->last(); ++i) {
      if (parts[i].is_beside && known.contains(all[i].color)) moved.push_back(i);
    }
  }
  for (const std::size_t i : moved) parts[i].is_beside = false;
}

/// The parts of one side that have no equal on the other.
Names missing(const std::vector<Part>& parts, const Side& here, const Side& there, std::size_t Part::*color) {
  const Colors known = colors_of(parts, there, color);
  Names names;
  for (std::size_t i = here.first(); i < here.last(); ++i) {
    if (!parts[i].is_beside && !known.contains(parts[i].*color)) names.emplace(parts[i].name, parts[i].is_code);
  }
  return names;
}

std::ptrdiff_t functions_among(const Names& names) {
  return std::count_if(names.begin(), names.end(), [](const auto& entry) { return entry.second; });
}

void print(const char* what, const Names& names) {
  const std::ptrdiff_t functions = functions_among(names);
  if (names.empty()) return;
  std::printf("%s: %td functions, %td constants\n", what, functions, static_cast<std::ptrdiff_t>(names.size()) - functions);
  for (const auto& [name, is_code] : names) std::printf("  %s%s\n", is_code ? "" : "constant ", name.c_str());
}

int compare(const char* one, const char* other) {
  std::vector<Part> parts;
  const Side here(one, parts);
  const Side there(other, parts);
  for (const Side* side : {&here, &there}) {
    if (side->first() == side->last()) throw std::runtime_error(std::string(side == &here ? one : other) + ": found no object files");
  }
  find_moved(parts, here, there);
  color(parts);
  const auto all_here = missing(parts, here, there, &Part::color), all_there = missing(parts, there, here, &Part::color);
  if (all_here.empty() && all_there.empty()) {
    std::printf("the same machine code: %zu and %zu functions and constants\n", here.last() - here.first(), there.last() - there.first());
    return 0;
  }
  auto itself_here = missing(parts, here, there, &Part::own_color), itself_there = missing(parts, there, here, &Part::own_color);
  // none is new by itself: they refer to others of those that both have
  if (itself_here.empty() && itself_there.empty()) itself_here = all_here, itself_there = all_there;
  Names changed;
  for (const auto& [name, is_code] : std::map(itself_here)) {
    if (itself_there.erase(name) > 0) changed.emplace(name, is_code), itself_here.erase(name);
  }
  std::printf("the machine code differs: %td functions of the first and %td of the second have no equal; those that differ themselves:\n",
              functions_among(all_here), functions_among(all_there));
  print("changed", changed);
  print("only in the first", itself_here);
  print("only in the second", itself_there);
  return 1;
}

}  // namespace

int main(int count, char** arguments) try {
  if (count == 3) return compare(arguments[1], arguments[2]);
  std::fputs("usage: bake-same-code <folder of object files> <folder of object files>\n", stderr);
  return 2;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
