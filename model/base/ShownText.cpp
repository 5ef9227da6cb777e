// SPDX-License-Identifier: MIT
#include "model/base/ShownText.h"

#include <algorithm>

namespace crowd::model {

namespace {

unsigned byteAt(std::string_view text, std::size_t place)
{
    return place < text.size() ? static_cast<unsigned char>(text[place]) : 0U;
}

bool isWithin(unsigned byte, unsigned low, unsigned high)
{
    return byte >= low && byte <= high;
}

/// Bytes of the character at a place, by table 3-7 of the Unicode Standard; 0: there is none.
std::size_t lengthOfCharacter(std::string_view text, std::size_t place)
{
    const unsigned first = byteAt(text, place);
    if (first < 0x80U) {
        return 1;
    }
    const std::size_t length = isWithin(first, 0xC2, 0xDF)   ? 2
                               : isWithin(first, 0xE0, 0xEF) ? 3
                               : isWithin(first, 0xF0, 0xF4) ? 4
                                                             : 0;
    const unsigned low = first == 0xE0U ? 0xA0U : first == 0xF0U ? 0x90U : 0x80U;
    const unsigned high = first == 0xEDU ? 0x9FU : first == 0xF4U ? 0x8FU : 0xBFU;
    if (length == 0 || !isWithin(byteAt(text, place + 1), low, high)) {
        return 0;
    }
    for (std::size_t i = 2; i < length; ++i) {
        if (!isWithin(byteAt(text, place + i), 0x80, 0xBF)) {
            return 0;
        }
    }
    return length;
}

bool isBegin(char byte)
{
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

/// Where the character of that number begins.
std::size_t placeOfCharacter(std::string_view text, std::size_t number)
{
    std::size_t place = 0;
    for (; place < text.size(); ++place) {
        if (isBegin(text[place]) && number-- == 0) {
            return place;
        }
    }
    return place;
}

} // namespace

std::string wellFormed(std::string text)
{
    std::string sound;
    std::size_t kept = 0; // of the text, what is in `sound` by now
    for (std::size_t place = 0; place < text.size();) {
        const std::size_t length = lengthOfCharacter(text, place);
        if (length == 0) {
            sound.append(text, kept, place - kept).append("\xEF\xBF\xBD");
            kept = place + 1;
        }
        place += std::max<std::size_t>(length, 1);
    }
    return kept == 0 ? std::move(text) : sound.append(text, kept);
}

std::string shortened(std::string_view text, std::size_t most)
{
    const auto count = static_cast<std::size_t>(std::ranges::count_if(text, isBegin));
    if (count <= most) {
        return std::string(text);
    }
    const std::size_t end = most / 4;
    return std::string(text.substr(0, placeOfCharacter(text, most - end - 1))) + "…" +
           std::string(text.substr(placeOfCharacter(text, count - end)));
}

} // namespace crowd::model
