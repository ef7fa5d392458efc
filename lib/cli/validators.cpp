#include "validators.hpp"

#include <cmath>
#include <optional>

#include "lepp/geometry/text.hpp"

namespace lepp::cli {

namespace {

bool is_above_zero(std::string_view text) {
  const auto value = number_in<double>(text);
  return value && *value > 0 && std::isfinite(*value);
}

std::string unless(bool fits, const std::string& text, const std::string& wanted) {
  return fits ? std::string() : "'" + text + "' does not fit: give " + wanted;
}

}  // namespace

CLI::Validator number_from(double least, double most) {
  return {[=](const std::string& text) {
            const auto value = number_in<double>(text);
            const bool fits = value && *value >= least && *value <= most && std::isfinite(*value);
            const std::string wanted = std::isfinite(most)
                                           ? "from " + to_text(least) + " to " + to_text(most)
                                           : "from " + to_text(least) + " on";
            return unless(fits, text, "a number " + wanted);
          },
          ""};
}

CLI::Validator number_above_zero() {
  return {
      [](const std::string& text) { return unless(is_above_zero(text), text, "a number above 0"); },
      ""};
}

CLI::Validator finite_number() {
  return {[](const std::string& text) {
            const auto value = number_in<double>(text);
            return unless(value && std::isfinite(*value), text, "a number");
          },
          ""};
}

CLI::Validator whole_number_from(std::uint64_t least) {
  return {[least](const std::string& text) {
            const auto value = number_in<std::uint64_t>(text);
            return unless(value && *value >= least, text,
                          "a whole number from " + std::to_string(least) + " on");
          },
          ""};
}

CLI::Validator named_size() {
  return {[](const std::string& text) {
            const std::size_t sign = text.rfind('=');
            const bool fits = sign != text.npos && sign > 0 &&
                              is_above_zero(std::string_view(text).substr(sign + 1));
            return unless(fits, text, "REGION=VALUE with a value above 0, such as 2=0.05");
          },
          ""};
}

}  // namespace lepp::cli
