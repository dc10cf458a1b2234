// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace bake {

/// What a compiler sees of a source: its tokens, one a line, without comments, blanks, line breaks and `#include "..."`.
/// A directive ends with an empty line. Two sources with the same text are the same to the compiler, whatever they look like.
std::string canonical_source(std::string_view source);

/// The canonical texts of all *.h, *.cpp and *.in below `folder`, sorted, so that neither names nor places of files count.
/// Left out are the folders `program` and `identity` in it, which do not decide a run's numbers.
/// Throws std::runtime_error if a file cannot be read, std::filesystem::filesystem_error if `folder` cannot.
std::string canonical_sources(const std::filesystem::path& folder);

}  // namespace bake
