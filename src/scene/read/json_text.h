#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace viewcover {

/// Refuses JSON that is nested deeper than 64 arrays and objects: what is done to values of any
/// depth, such as copying them, goes as deep into the stack. `place` is for the message.
/// Errors: InputError. Cost: linear.
void refuse_deep_json(std::string_view text, std::string_view place);

/// The value that a JSON text stands for. `file` names it in messages.
/// Errors: InputError with the line for malformed JSON, numbers beyond the range of double and
/// deep nesting.
nlohmann::json parse_json(std::string_view text, const std::string& file);

}  // namespace viewcover
