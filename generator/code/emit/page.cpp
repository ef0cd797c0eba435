// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/page.hpp"

#include <stdexcept>

namespace flatdyn {

kainjow::mustache::data list_of(const std::vector<std::string>& texts) {
  kainjow::mustache::data list(kainjow::mustache::data::type::list);
  for (const std::string& text : texts) list << kainjow::mustache::data(text);
  return list;
}

namespace {

std::string filled(kainjow::mustache::mustache sheet, const kainjow::mustache::data& page) {
  const std::string result = sheet.render(page);
  if (!sheet.is_valid()) throw std::logic_error("template: " + sheet.error_message());
  return result;
}

}  // namespace

std::string rendered(const char* text, const kainjow::mustache::data& page) {
  kainjow::mustache::mustache sheet(text);
  sheet.set_custom_escape([](const std::string& written) { return written; });
  return filled(std::move(sheet), page);
}

std::string rendered_html(const char* text, const kainjow::mustache::data& page) {
  return filled(kainjow::mustache::mustache(text), page);
}

std::string html_text(const std::string& text) { return kainjow::mustache::html_escape(text); }

}  // namespace flatdyn
