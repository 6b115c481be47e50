#pragma once
/// The page's own files (assets/) and the charting library, built into the program as text.

#include <string_view>

namespace similitude {

extern const std::string_view k_page;           // page.html, with {{names}} of the rest
extern const std::string_view k_page_style;     // style.css
extern const std::string_view k_page_base;      // base.js
extern const std::string_view k_page_charts;    // charts.js
extern const std::string_view k_page_bed;       // bed.js
extern const std::string_view k_page_sections;  // sections.js
extern const std::string_view k_chart_library;  // Chart.js, MIT licence
extern const std::string_view k_chart_licence;  // its text

}  // namespace similitude
