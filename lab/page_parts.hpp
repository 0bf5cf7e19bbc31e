// SPDX-License-Identifier: Apache-2.0
//
// The files of lab/page/ and uPlot as text; defined in a unit that embed_page.cmake writes.
#pragma once

#include <string_view>

namespace trammel::lab {

extern const std::string_view kPageHtml;    // with @TITLE@, @STYLE@, @DATA@ and @SCRIPT@
extern const std::string_view kPageStyle;
extern const std::string_view kPageScript;

}  // namespace trammel::lab
