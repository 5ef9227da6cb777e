// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "behavior/session/Session.h"

/// What rules set of people while a session runs: colours, height, the clip that they have while
/// they stand or sit.
namespace crowd::behavior {

namespace {

constexpr float kLeastHeight = 0.05F;
constexpr float kMostHeight = 20.0F;
constexpr float kMostRate = 100.0F;

} // namespace

SetLook& Session::lookOf(std::uint32_t agent)
{
    m_areLooksStale = true;
    SetLook& look = m_looks[m_population.ids()[agent]];
    look.id = m_population.ids()[agent];
    return look;
}

void Session::publishLooks()
{
    if (!m_areLooksStale) {
        return;
    }
    m_areLooksStale = false;
    auto looks = std::make_shared<std::vector<SetLook>>();
    looks->reserve(m_looks.size());
    for (const auto& [id, look] : m_looks) {
        looks->push_back(look);
    }
    m_shownLooks = std::move(looks);
}

std::uint16_t Session::ownClip(std::uint32_t agent) const
{
    const int base = m_shown[agent].base;
    return base >= 0 ? static_cast<std::uint16_t>(base)
                     : m_population.column(model::columns::clip)[agent];
}

float Session::ownRate(std::uint32_t agent) const
{
    return m_shown[agent].rate.value_or(m_population.column(model::columns::playbackSpeed)[agent]);
}

double Session::ownPhase(std::uint32_t agent) const
{
    return m_shown[agent].phase.value_or(
        static_cast<double>(m_population.column(model::columns::phase)[agent]));
}

double Session::ownPlace(std::uint32_t agent) const
{
    const ClipFacts* facts = clipFacts(m_shown[agent], ownClip(agent));
    const double passed =
        facts != nullptr && facts->seconds > 0.0F
            ? seconds() * static_cast<double>(ownRate(agent)) / static_cast<double>(facts->seconds)
            : 0.0;
    return passed + ownPhase(agent);
}

/// So that he is there in his own clip now.
void Session::setOwnPhase(std::uint32_t agent, double place)
{
    Shown& shown = markDirty(agent);
    shown.phase = 0.0;
    const double phase = place - ownPlace(agent);
    shown.phase = phase - std::floor(phase);
    lookOf(agent).phase = static_cast<float>(*shown.phase);
}

void Session::setOwnRate(std::uint32_t agent, float rate)
{
    const double place = ownPlace(agent);
    markDirty(agent).rate = rate;
    lookOf(agent).playbackSpeed = rate;
    setOwnPhase(agent, place); // goes on from where it is
}

/// Another clip to sit or to stand with, by what he does; one that a rule has set counts no more.
void Session::setBase(std::uint32_t agent, int clip)
{
    markDirty(agent).base = clip;
    const auto found = m_looks.find(m_population.ids()[agent]);
    if (found != m_looks.end() && found->second.clip) {
        found->second.clip.reset();
        m_areLooksStale = true;
    }
}

void Session::setOwnClip(std::uint32_t agent, const std::string& name)
{
    Shown& shown = markDirty(agent);
    const int clip = clipNamed(shown, name.c_str());
    if (clip < 0 || clip == static_cast<int>(ownClip(agent))) {
        return;
    }
    shown.base = clip;
    lookOf(agent).clip = static_cast<std::uint16_t>(clip);
    setOwnPhase(agent, 0.0);
}

void Session::setTint(std::uint32_t agent, const model::Action& action)
{
    const model::TemplateEntry* entry = entryOf(m_shown[agent]);
    const std::size_t count =
        entry != nullptr && entry->asset
            ? std::min<std::size_t>(entry->asset->slots.size(), model::kMaxTintSlots)
            : 0;
    for (std::size_t slot = 0; slot < count; ++slot) {
        const model::Slot& each = entry->asset->slots[slot];
        if (action.slot.empty() ? each.tintable : each.name == action.slot) {
            SetLook& look = lookOf(agent);
            look.tinted = static_cast<std::uint8_t>(look.tinted | (1U << slot));
            look.tints[slot] = action.tint;
        }
    }
}

void Session::setProperty(std::uint32_t agent, const model::Action& action, const std::string& clip)
{
    Shown& shown = markDirty(agent);
    switch (action.property) {
    case model::SettableProperty::Tint:
        setTint(agent, action);
        return;
    case model::SettableProperty::Height:
        shown.height = std::clamp(action.value, kLeastHeight, kMostHeight);
        lookOf(agent).height = shown.height;
        return;
    case model::SettableProperty::PlaybackSpeed:
        activate(agent);
        setOwnRate(agent, std::clamp(action.value, 0.0F, kMostRate));
        return;
    case model::SettableProperty::Clip:
        activate(agent);
        setOwnClip(agent, clip);
        return;
    case model::SettableProperty::Phase:
        activate(agent);
        setOwnPhase(agent, static_cast<double>(std::clamp(action.value, 0.0F, 1.0F)));
        return;
    }
}

void Session::noteTags(std::uint32_t agent, std::uint64_t tags)
{
    lookOf(agent).tags = tags;
}

void Session::forgetLook(std::uint32_t agent, model::ColumnId column)
{
    const auto found = m_looks.find(m_population.ids()[agent]);
    if (found == m_looks.end()) {
        return;
    }
    namespace keys = model::columns;
    SetLook& look = found->second;
    m_areLooksStale = true;
    const auto slot = static_cast<unsigned>(column) - static_cast<unsigned>(keys::tint(0).id);
    if (column == keys::height.id) {
        look.height.reset();
    } else if (column == keys::clip.id && look.clip) {
        look.clip.reset();
        m_shown[agent].base = -1;
    } else if (column == keys::phase.id) {
        look.phase.reset();
        m_shown[agent].phase.reset();
    } else if (column == keys::playbackSpeed.id) {
        look.playbackSpeed.reset();
        m_shown[agent].rate.reset();
    } else if (slot < static_cast<unsigned>(model::kMaxTintSlots)) {
        look.tinted = static_cast<std::uint8_t>(look.tinted & ~(1U << slot));
    }
}

float Session::property(std::uint32_t agent, model::ComparedProperty property) const
{
    switch (property) {
    case model::ComparedProperty::Height:
        return m_shown[agent].height;
    case model::ComparedProperty::Girth:
        return m_population.column(model::columns::girth)[agent];
    case model::ComparedProperty::PlaybackSpeed:
        return ownRate(agent);
    case model::ComparedProperty::WalkSpeed:
        return m_follower.pace(agent);
    case model::ComparedProperty::Clip:
        break;
    }
    return 0.0F;
}

bool Session::showsClip(std::uint32_t agent, const std::string& clip) const
{
    const int named = clipNamed(m_shown[agent], clip.c_str());
    return named >= 0 && static_cast<int>(showingOf(agent).clip.clip) == named;
}

} // namespace crowd::behavior
