// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/toml/table.hpp"

#include <algorithm>
#include <tuple>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/expression.hpp"
#include "robot/input/common/linear_position.hpp"
#include "robot/input/common/units.hpp"
#include "robot/model/unit_plausibility.hpp"

namespace flatdyn {

namespace {

std::string with_key(const std::string& what, std::string_view key) {
  return what.empty() ? std::string(key) : what + ", " + std::string(key);
}

// Checks the value or, if it has symbols, each number among its terms and factors.
bool check_magnitudes(const Number& value, const std::string& shown, const Spot& spot, Diagnostics& diagnostics) {
  if (!has_symbols(value)) return check_magnitude(value, shown, spot, diagnostics);
  if (GiNaC::is_a<GiNaC::power>(value)) return check_magnitudes(value.op(0), shown, spot, diagnostics);
  return std::all_of(value.begin(), value.end(),
                     [&](const Number& part) { return check_magnitudes(part, shown, spot, diagnostics); });
}

// The hint for an error of TOML's parser, by words of its description. If it has several, the first counts.
struct HintForMalformed {
  const char *words, *hint;
};
constexpr HintForMalformed kHintsForMalformed[] = {
    // TOML's own numbers are doubles and integers of 64 bits; the parser refuses others before we see them.
    {"not representable in 64 bits", "write so large a number with a decimal point or an exponent"},
    {"could not be interpreted as a value", "numbers go from 1e-30 to 1e30"},
    {"leading zeroes", "write 5, not 05"},
    {"hexadecimal", "write the number in decimal"},
    {"parsing floating-point",
     "write a number as 0.5, 2.0 or 1e-3: with digits on both sides of its point, and one "
     "point only"},
    {"parsing decimal integer", "write a number as 5, 0.5 or 1e-3; a text or an expression needs quotes: \"pi/2\""},
    {"parsing date", "numbers have no - inside; a text or an expression needs quotes: \"2 - 1\""},
    {"parsing time", "numbers have no : inside; a text needs quotes"},
    {"parsing boolean", "write true or false in small letters; a text needs quotes"},
    {"utf-8", "save the file as text in UTF-8"},
    {"escape sequence", "write the text in single quotes, 'C:\\robots', or each backslash twice"},
    {"parsing string: encountered end-of-file", "the text has no quote at its end"},
    {"literal string: encountered end-of-file", "the text has no quotes at its end"},
    {"parsing string: unescaped control", "the text has no quote at the end of its line, or a control character in it"},
    {"control character", "remove the control character"},
    {"parsing array: encountered end-of-file", "the list has no ] at its end"},
    {"expected comma or closing ']'", "a list has commas between its values, and a ] at its end: [0, 0, 1]"},
    {"parsing inline table: encountered end-of-file", "the table has no } at its end"},
    {"dangling comma", "delete the comma before }"},
    {"parsing inline table",
     "a table in braces is in one line, with commas between its keys: { mass = 1, com = [0, 0, 1] }"},
    {"as array-of-tables", "[name] or name = ... and [[name]] cannot both stand in a file: write [[name]] for each"},
    {"existing table",
     "a table stands once in a file: write all its keys below one [name], or [[name]] for each of several"},
    {"cannot redefine", "a key stands once in its table: delete one of the two"},
    {"into existing inline table", "write all keys of the table within its braces"},
    {"parsing table header", "tables are [name], arrays of tables [[name]], each in a line of its own"},
    {"expected '='", "a line is key = value, and a comment begins with #"},
    {"expected a comment or whitespace",
     "one key stands in a line; a text or an expression needs quotes, a list [ ], and "
     "decimals a point: 0.5"},
    {"parsing key-value pair: encountered end-of-file", "a line is key = value"},
    {"expected keys, tables", "a line is key = value, [table], [[array of tables]] or # comment"},
    {"maximum nested value depth", "write fewer brackets within each other"},
};

std::string hint_for_malformed(const std::string& description) {
  for (const HintForMalformed& each : kHintsForMalformed) {
    if (description.find(each.words) != std::string::npos) return each.hint;
  }
  return "a text needs quotes, and so does an expression: name = \"arm\", alpha = \"pi/2\"";
}

}  // namespace

TomlSource::TomlSource(std::string text, std::string file, ReadContext& context, std::string documentation)
    : text_(std::move(text)), file_(std::move(file)), context_(context), documentation_(std::move(documentation)) {
  if (text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3);  // a byte order mark counts as no column
  line_starts_.push_back(0);
  for (std::size_t i = 0; i < text_.size(); ++i) {
    if (text_[i] == '\n') line_starts_.push_back(i + 1);
  }
}

std::optional<toml::table> TomlSource::parse() const {
  try {
    return toml::parse(std::string_view(text_), std::string_view(file_));
  } catch (const toml::parse_error& error) {
    const std::string description(error.description());
    context_.diagnostics.error(place(error.source()), "not well-formed TOML: " + description,
                               hint_for_malformed(description));
    return std::nullopt;
  }
}

Place TomlSource::place(const toml::source_region& region) const {
  return {file_, static_cast<int>(region.begin.line)};
}

std::string TomlSource::text_of(const toml::source_region& region) const {
  if (region.begin.line == 0 || region.begin.line > line_starts_.size()) return "";
  // Columns count code points: a byte of the form 10xxxxxx goes on with the one before.
  std::size_t position = line_starts_[region.begin.line - 1];
  const auto advance = [&](std::size_t columns) {
    for (; columns > 0 && position < text_.size(); --columns) {
      do ++position;
      while (position < text_.size() && (static_cast<unsigned char>(text_[position]) & 0xC0U) == 0x80U);
    }
    return position;
  };
  const std::size_t begin = advance(region.begin.column - 1);
  const std::size_t end = advance(region.end.column - region.begin.column);
  return text_.substr(begin, end - begin);
}

const toml::node* TomlTable::find(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  const toml::node* node = table_.get(key);
  const toml::array* list = element_ && node != nullptr ? node->as_array() : nullptr;
  return list != nullptr && *element_ < list->size() ? list->get(*element_) : node;
}

TomlTable TomlTable::with_element(std::size_t k, const std::string& what) const {
  TomlTable element(table_, what, source_);
  element.element_ = k;
  return element;
}

Place TomlTable::place_of(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return node == nullptr ? place() : source_.place(node->source());
}

Spot TomlTable::spot(const toml::node& node, std::string_view key) const {
  return {source_.place(node.source()), with_key(what_, key)};
}

void TomlTable::report_kind(const toml::node& node, std::string_view key, const std::string& expected,
                            const std::string& hint) const {
  const Spot where = spot(node, key);
  source_.context().diagnostics.error(
      where.place, where.what + ": " + expected + " is expected",
      hint.empty() ? source_.documentation() + " lists the keys and their values" : hint);
}

std::optional<std::string> TomlTable::text(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (const auto* string = node->as_string()) return string->get();
  report_kind(*node, key, "a text in quotes");
  return std::nullopt;
}

std::optional<Reference> TomlTable::reference(std::string_view key) {
  const std::optional<std::string> name = text(key);
  return name ? std::optional<Reference>({*name, place_of(key)}) : std::nullopt;
}

std::vector<Reference> TomlTable::references(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  std::vector<Reference> all;
  const toml::array* array = node->as_array();
  if (array == nullptr || !std::all_of(array->begin(), array->end(), [](const auto& e) { return e.is_string(); })) {
    report_kind(*node, key, "a list of texts in quotes");
    return {};
  }
  for (const toml::node& element : *array) all.push_back({element.as_string()->get(), source_.place(element.source())});
  return all;
}

std::optional<bool> TomlTable::boolean(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (const auto* value = node->as_boolean()) return value->get();
  report_kind(*node, key, "true or false");
  return std::nullopt;
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> all;
  for (const auto& [key, node] : table_) all.emplace_back(key.str());
  return all;
}

std::optional<JointPosition> TomlTable::locked_joint(const std::string& joint) {
  const toml::node* node = find(joint);
  if (node == nullptr) return std::nullopt;
  const std::string written = node->is_string() ? node->as_string()->get() : source_.text_of(node->source());
  const std::optional<std::string> degrees = node->is_string() ? number_of_degrees(written) : std::nullopt;
  const std::optional<Number> position =
      degrees ? expression_of(*node, *degrees, spot(*node, joint)) : number_of(*node, joint);
  if (!position) return std::nullopt;
  const bool is_decimal = degrees ? is_decimal_text(*degrees) : !node->is_string();
  return JointPosition{joint, *position, written, is_decimal, source_.place(node->source()), degrees.has_value()};
}

std::optional<Coupled> TomlTable::linear_position(std::string_view key, JointType type) {
  const std::optional<std::string> expression = text(key);
  if (!expression) return std::nullopt;
  return read_linear_position(*expression, type, source_.units(), {place_of(key), with_key(what_, key)},
                              source_.context());
}

std::optional<Coupled> TomlTable::tendon_length(std::string_view key) {
  const std::optional<std::string> expression = text(key);
  if (!expression) return std::nullopt;
  return read_linear_position(*expression, JointType::prismatic, {}, {place_of(key), with_key(what_, key)},
                              source_.context());
}

std::optional<Number> TomlTable::expression_of(const toml::node& node, const std::string& text, const Spot& spot) {
  ReadContext& context = source_.context();
  const toml::source_index column = node.source().begin.column;
  const auto symbol = [&](std::string_view name, std::size_t offset) -> Number {
    return context.symbols.get(name, spot.place, column + offset, context.diagnostics);
  };
  constexpr std::size_t kShown = 40;
  const std::string shown = "\"" + (text.size() > kShown ? text.substr(0, kShown) + "..." : text) + "\"";
  try {
    const Number value = parse_expression(text, symbol);
    const std::string numbers = has_symbols(value) ? "a number in " + shown : shown;
    if (check_magnitudes(value, numbers, spot, context.diagnostics)) return value;
  } catch (const ExpressionError& error) {
    context.diagnostics.error(
        spot.place, spot.what + ": " + shown + ": " + error.what() + " (column " + std::to_string(error.column()) + ")",
        "e.g. 0.25, \"pi/2\", \"sqrt(2)/2\", \"2*l_1 - a_1\"");
  }
  return std::nullopt;
}

std::optional<Number> TomlTable::number_of(const toml::node& node, std::string_view key) {
  const Spot where = spot(node, key);
  if (const auto* string = node.as_string()) return expression_of(node, string->get(), where);
  if (const auto* integer = node.as_integer())
    return checked_decimal(std::to_string(integer->get()), where, source_.context().diagnostics);
  if (!node.is_floating_point()) {
    report_kind(node, key, "a number or an expression in quotes");
    return std::nullopt;
  }
  std::string text = source_.text_of(node.source());
  std::erase(text, '_');  // TOML lets digits be grouped: 1_000.0
  return checked_decimal(text, where, source_.context().diagnostics);
}

Number TomlTable::in_si(const Number& written, Quantity quantity, const Spot& spot) {
  ReadContext& context = source_.context();
  context.symbols.check_quantity(written, quantity, spot.place, context.diagnostics);
  if (quantity == Quantity::angle) return in_radians(written, source_.units(), spot, context.diagnostics);
  return quantity == Quantity::length ? in_metres(written, source_.units(), spot, context.diagnostics) : written;
}

std::optional<Value> TomlTable::value_in_si(std::string_view key, Quantity quantity) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const std::optional<Number> exact = number_of(*node, key);
  if (!exact) return std::nullopt;
  const Spot where = spot(*node, key);
  return Value{in_si(*exact, quantity, where), where.place};
}

std::optional<Value> TomlTable::number(std::string_view key, Quantity quantity) {
  std::optional<Value> value = value_in_si(key, quantity);
  if (value && quantity == Quantity::length) {
    note_length(value->number, {value->place, with_key(what_, key)}, source_.units(), source_.context());
  }
  return value;
}

Value TomlTable::number_or_zero(std::string_view key, Quantity quantity) {
  return number(key, quantity).value_or(Value{0, place()});
}

std::optional<Value> TomlTable::limit(std::string_view key, Quantity quantity, Bound bound) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  std::string written = node->is_string() ? node->as_string()->get() : source_.text_of(node->source());
  std::erase(written, '_');
  if ((node->is_string() || node->is_number()) && is_infinite_limit(written)) {
    check_infinite_limit(written, bound, spot(*node, key), source_.context().diagnostics);
    return std::nullopt;
  }
  std::optional<Value> value = value_in_si(key, quantity);
  if (!value || !has_symbols(value->number)) return value;
  source_.context().diagnostics.unsupported(value->place,
                                            with_key(what_, key) + ": a symbol as a limit is not supported",
                                            "limits are constants of the generated code: write a number");
  return std::nullopt;
}

const toml::array* TomlTable::three(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return nullptr;
  const toml::array* array = node->as_array();
  if (array != nullptr && array->size() == 3) return array;
  report_kind(*node, key, "a list of three numbers, [x, y, z],");
  return nullptr;
}

Vec3 TomlTable::vector(std::string_view key, Quantity quantity, const Vec3& fallback) {
  const toml::array* array = three(key);
  if (array == nullptr) return fallback;
  Vec3 values;
  for (std::size_t i = 0; i < 3; ++i) {
    const toml::node& node = *array->get(i);
    const std::optional<Number> value = number_of(node, key);
    if (!value) return fallback;
    const Spot where = spot(node, key);
    values[i] = in_si(*value, quantity, where);
    if (quantity == Quantity::length) note_length(values[i], where, source_.units(), source_.context());
  }
  return values;
}

std::optional<Value> TomlTable::plain_number(const toml::node& node, std::string_view key) {
  const std::optional<Number> exact = number_of(node, key);
  if (!exact) return std::nullopt;
  const Place where = source_.place(node.source());
  if (!has_symbols(*exact)) return Value{*exact, where};
  source_.context().diagnostics.error(where, with_key(what_, key) + ": a symbol stands for no number here",
                                      "write a number");
  return std::nullopt;
}

std::optional<std::vector<Value>> TomlTable::numbers(std::string_view key, std::size_t count) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    const std::optional<Value> one = plain_number(*node, key);
    return one ? std::optional(std::vector(count, *one)) : std::nullopt;
  }
  if (array->size() != count) {
    report_kind(*node, key, "a list of " + std::to_string(count) + " numbers, or one number,");
    return std::nullopt;
  }
  std::vector<Value> values;
  for (const toml::node& element : *array) {
    const std::optional<Value> value = plain_number(element, key);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

std::optional<std::vector<Value>> TomlTable::numbers(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    report_kind(*node, key, "a list of numbers");
    return std::nullopt;
  }
  std::vector<Value> all;
  for (const toml::node& element : *array) {
    const std::optional<Number> value = number_of(element, key);
    if (!value) return std::nullopt;
    all.push_back({*value, source_.place(element.source())});
  }
  return all;
}

Number TomlTable::angle_of(const toml::node& node, std::string_view key) {
  ReadContext& context = source_.context();
  const Spot where = spot(node, key);
  const Number written = number_of(node, key).value_or(0);
  const Number angle = node.is_string()
                           ? canonical_angle(in_si(written, Quantity::angle, where), where, context.diagnostics)
                           : decimal_angle(written, source_.text_of(node.source()), source_.units(), where, context);
  if (!source_.units().degrees && may_be_degrees(angle)) {
    warn_of_degrees(angle, where, degrees_hint(written), context.diagnostics);
  }
  return angle;
}

Number TomlTable::angle(std::string_view key) {
  const toml::node* node = find(key);
  return node == nullptr ? Number(0) : angle_of(*node, key);
}

Vec3 TomlTable::angles(std::string_view key) {
  const toml::array* array = three(key);
  if (array == nullptr) return zero_vector();
  return {angle_of(*array->get(0), key), angle_of(*array->get(1), key), angle_of(*array->get(2), key)};
}

std::optional<TomlTable> TomlTable::table(std::string_view key, const std::string& hint) {
  const toml::node* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (const toml::table* dot = node->as_table()) {
    TomlTable inner(*dot, with_key(what_, key), source_);
    inner.element_ = element_;
    return inner;
  }
  report_kind(*node, key, "a table", hint);
  return std::nullopt;
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return {};
  const toml::array* array = node->as_array();
  if (array == nullptr || !std::all_of(array->begin(), array->end(), [](const auto& e) { return e.is_table(); })) {
    report_kind(*node, key, "an array of tables, [[" + std::string(key) + "]],");
    return {};
  }
  std::vector<TomlTable> all;
  for (const toml::node& element : *array) all.emplace_back(*element.as_table(), std::string(key), source_);
  return all;
}

void TomlTable::reject_unknown_keys() const {
  std::vector<std::tuple<toml::source_index, std::string>> unknown;
  for (const auto& [key, node] : table_) {
    if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
    unknown.emplace_back(key.source().begin.line, std::string(key.str()));
  }
  std::sort(unknown.begin(), unknown.end());
  for (const auto& [line, key] : unknown) {
    const Place where{place().file, static_cast<int>(line)};
    source_.context().diagnostics.error(where, (what_.empty() ? "" : what_ + ": ") + "unknown key \"" + key + "\"",
                                        hint_for_unknown(key, known_, "keys"));
  }
}

}  // namespace flatdyn
