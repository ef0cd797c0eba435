// SPDX-License-Identifier: GPL-2.0-or-later
// Words and texts of Rust.
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

// The keywords of Rust, those of later editions too, in addition to those of C++.
std::vector<std::string> rust_keywords();

// The name of a crate for the name of its folder: an identifier that no other crate has by itself.
std::string crate_name(const std::string& file_name);

// `text` as a string literal in ASCII, whatever its bytes.
std::string rust_string(const std::string& text);

}  // namespace flatdyn
