// SPDX-License-Identifier: MIT
#pragma once

namespace bake::report {

/// The style sheet of the page, for light and dark, wide and narrow screens and for paper. It loads nothing.
extern const char* const k_style;

}  // namespace bake::report
