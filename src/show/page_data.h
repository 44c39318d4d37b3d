#pragma once

#include <string>

#include "compare/common_elements.h"
#include "show/camera.h"

namespace viewcover {

/// What a page shows.
struct PageContent {
  const RunData& run;
  const CommonElements& shown;
  const RunData* other = nullptr;    ///< the run it is compared with
  std::string run_name, other_name;  ///< of the two runs, for people; any bytes
  int up_axis = 2;
  ViewDirection view;
};

/// The content as JSON in ASCII that holds no `<`, so that no name in it ends a script element.
/// Numbers count from 0; lists of numbers, coordinates (single precision) and bit rows (whole bytes
/// a row, lowest bit first) are little-endian in base64. src/show/page/data.js reads it.
std::string page_data(const PageContent& content);

}  // namespace viewcover
