// SPDX-License-Identifier: MIT
#include "model/brush/SlotChoice.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace crowd::model {

bool isOfTheBody(const std::string& slot)
{
    static const std::set<std::string> kBody{"beard", "body", "brows", "eye",  "eyes", "face",
                                             "fur",   "hair", "head",  "skin", "teeth"};
    std::string word;
    for (std::size_t i = 0; i <= slot.size(); ++i) {
        const auto letter = static_cast<unsigned char>(i < slot.size() ? slot[i] : ' ');
        const bool startsWord = std::isupper(letter) != 0 && i > 0 &&
                                std::islower(static_cast<unsigned char>(slot[i - 1])) != 0;
        if (std::isalpha(letter) == 0 || startsWord) {
            if (kBody.contains(word)) {
                return true;
            }
            word.clear();
        }
        if (std::isalpha(letter) != 0) {
            word += static_cast<char>(std::tolower(letter));
        }
    }
    return false;
}

ColourSlots::ColourSlots(const Template& asset, const std::string& slot, bool sparesBody)
    : m_slot(slot),
      m_sparesBody(sparesBody && std::ranges::any_of(asset.slots, [](const Slot& each) {
                       return each.tintable && !isOfTheBody(each.name);
                   }))
{
}

bool ColourSlots::contains(const Slot& slot) const
{
    if (!m_slot.empty()) {
        return slot.name == m_slot;
    }
    return slot.tintable && !(m_sparesBody && isOfTheBody(slot.name));
}

} // namespace crowd::model
