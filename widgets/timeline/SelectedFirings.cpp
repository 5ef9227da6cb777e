// SPDX-License-Identifier: MIT
#include "widgets/timeline/SelectedFirings.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include <QtCore/QStringList>

namespace crowd::widgets {

namespace {

constexpr int kMostLines = 6;

} // namespace

SelectedFirings::SelectedFirings(EditorState& state) : m_state(state)
{
    connect(&state.selection(), &Selection::changed, this, &SelectedFirings::readAnew);
    connect(&state.session(), &SessionControl::stepped, this, &SelectedFirings::readOn);
    connect(&state.session(), &SessionControl::stateChanged, this, &SelectedFirings::readOn);
    readAnew();
}

void SelectedFirings::readAnew()
{
    const FiringHistory& history = m_state.session().firings();
    m_shown.clear();
    m_begin = history.begin();
    m_seen = m_begin;
    readOn();
    Q_EMIT changed();
}

void SelectedFirings::readOn()
{
    const FiringHistory& history = m_state.session().firings();
    if (history.begin() != m_begin) {
        readAnew(); // another run, or the earliest are forgotten
        return;
    }
    const std::size_t before = m_shown.size();
    if (!m_state.selection().isEmpty()) {
        std::ranges::copy_if(history.since(m_seen), std::back_inserter(m_shown),
                             [this](const behavior::RuleFired& each) {
                                 return m_state.selection().contains(each.who);
                             });
    }
    m_seen = history.end();
    if (m_shown.size() != before) {
        Q_EMIT changed();
    }
}

QString SelectedFirings::text(double from, double to) const
{
    struct Firing
    {
        double seconds = 0.0;
        std::set<model::IndividualId> people;
    };
    std::map<model::RuleId, Firing> firings;
    auto each = std::ranges::lower_bound(m_shown, from, {}, &behavior::RuleFired::seconds);
    for (; each != m_shown.end() && each->seconds <= to; ++each) {
        Firing& firing = firings.try_emplace(each->rule, Firing{each->seconds, {}}).first->second;
        firing.people.insert(each->who);
    }
    QStringList lines;
    for (const auto& [rule, firing] : firings) {
        const auto& rules = m_state.scene().rules;
        const auto found = std::ranges::find(rules, rule, &model::Rule::id);
        const QString name =
            found == rules.end() ? tr("a rule") : QString::fromStdString(found->name);
        lines << tr("%1, at %2 s, for %n character(s)", nullptr,
                    static_cast<int>(firing.people.size()))
                     .arg(name)
                     .arg(firing.seconds, 0, 'f', 2);
    }
    return QStringList(lines.mid(0, kMostLines)).join(QLatin1Char('\n'));
}

} // namespace crowd::widgets
