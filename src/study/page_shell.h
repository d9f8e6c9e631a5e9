#pragma once
#include <string_view>

namespace havs {

/// The study's page without its data: HTML with styles, scripts and Vega inlined, and one mark, kPageData, where the
/// data goes. From the files of src/study/page (cmake/HavsPage.cmake).
std::string_view pageShell();
inline constexpr std::string_view kPageData = "<!--HAVS:DATA-->";

}  // namespace havs
