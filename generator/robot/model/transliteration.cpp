// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/transliteration.hpp"

#include <fmt/format.h>

#include <array>

namespace flatdyn {

namespace {

// Words for consecutive characters, separated by blanks: "-" separates words of a name, "." stands for no letters.
struct Block {
  char32_t first;
  std::string_view words;
};

constexpr auto kBlocks = std::to_array<Block>({
    {0xB5, "mu"},
    {0xC0,
     "A A A A A A AE C E E E E I I I I D N O O O O O - O U U U U Y Th ss a a a a a a ae c e e e e i i i i "
     "d n o o o o o - o u u u u y th y A a A a A a C c C c C c C c D d D d E e E e E e E e E e G g G g G g "
     "G g H h H h I i I i I i I i I i IJ ij J j K k k L l L l L l L l L l N n N n N n n Ng ng O o O o O o "
     "OE oe R r R r R r S s S s S s S s T t T t T t U u U u U u U u U u U u W w Y y Y Z z Z z Z z s"},
    {0x391,
     "Alpha Beta Gamma Delta Epsilon Zeta Eta Theta Iota Kappa Lambda Mu Nu Xi Omicron Pi Rho - Sigma Tau "
     "Upsilon Phi Chi Psi Omega"},
    {0x3B1,
     "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho sigma sigma "
     "tau upsilon phi chi psi omega"},
    {0x410,
     "A B V G D E Zh Z I J K L M N O P R S T U F H C Ch Sh Shch . Y . E Yu Ya a b v g d e zh z i j k l m n "
     "o p r s t u f h c ch sh shch . y . e yu ya"},
});

// The word for a character; "" if the block has none.
std::string_view word_of(const Block& block, char32_t character) {
  if (character < block.first) return "";
  std::string_view words = block.words;
  for (char32_t k = block.first; k < character; ++k) {
    const std::size_t blank = words.find(' ');
    if (blank == std::string_view::npos) return "";
    words.remove_prefix(blank + 1);
  }
  return words.substr(0, words.find(' '));
}

}  // namespace

std::string transliterated(char32_t character) {
  constexpr char32_t kFirstLetter = 0xC0;  // smaller characters are signs
  for (const Block& block : kBlocks) {
    const std::string_view word = word_of(block, character);
    if (!word.empty()) return word == "." ? "" : std::string(word);
  }
  return character < kFirstLetter ? "-" : fmt::format("-u{:x}-", static_cast<std::uint32_t>(character));
}

}  // namespace flatdyn
