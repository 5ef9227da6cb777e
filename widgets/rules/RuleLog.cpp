// SPDX-License-Identifier: MIT
#include "widgets/rules/RuleLog.h"

#include <algorithm>
#include <limits>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>

namespace crowd::widgets {

namespace {

constexpr double kPauseSeconds = 1.0; ///< after which a rule begins another line
constexpr std::size_t kMaxBursts = 400;
constexpr std::size_t kMaxTallies = 200000;
constexpr std::size_t kMaxNamed = 4; ///< people who are told apart in a line

struct RuleLogText
{
    Q_DECLARE_TR_FUNCTIONS(RuleLog)
};

/// Of one line.
struct Sum
{
    std::vector<model::IndividualId> people;
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t most = 0;
    std::uint64_t all = 0;
    double first = std::numeric_limits<double>::max();
    double last = 0.0;
};

QString secondsText(const Sum& sum)
{
    const QString first = QLocale().toString(sum.first, 'f', 2);
    const QString last = QLocale().toString(sum.last, 'f', 2);
    return first == last ? first : RuleLogText::tr("%1–%2").arg(first, last);
}

QString peopleText(const Sum& sum)
{
    if (sum.people.size() == 1) {
        return RuleLogText::tr("character %1").arg(sum.people.front());
    }
    if (sum.people.size() > kMaxNamed) {
        return RuleLogText::tr("%n characters", nullptr, static_cast<int>(sum.people.size()));
    }
    QStringList names;
    for (const model::IndividualId who : sum.people) {
        names << QString::number(who);
    }
    return RuleLogText::tr("characters %1").arg(names.join(RuleLogText::tr(", ")));
}

int shownCount(std::uint64_t count)
{
    constexpr std::uint64_t kMost = std::numeric_limits<int>::max();
    return static_cast<int>(std::min(count, kMost));
}

QString lineText(const Sum& sum, const QString& rule)
{
    QString line = RuleLogText::tr("%1 s · %2 · %3").arg(secondsText(sum), peopleText(sum), rule);
    if (sum.most == 1) {
        return line;
    }
    if (sum.people.size() == 1) {
        return RuleLogText::tr("%1 · %n times", nullptr, shownCount(sum.all)).arg(line);
    }
    return sum.least == sum.most
               ? RuleLogText::tr("%1 · %n times each", nullptr, shownCount(sum.most)).arg(line)
               : RuleLogText::tr("%1 · %n times in all", nullptr, shownCount(sum.all)).arg(line);
}

} // namespace

void RuleLog::clear()
{
    m_bursts.clear();
    m_tallies = 0;
}

/// The one that goes on, or a new one.
RuleLog::Burst& RuleLog::burstOf(const behavior::RuleFired& fired)
{
    const auto found = std::find_if(m_bursts.rbegin(), m_bursts.rend(),
                                    [&](const Burst& burst) { return burst.rule == fired.rule; });
    if (found != m_bursts.rend() && fired.seconds - found->last <= kPauseSeconds) {
        return *found;
    }
    m_bursts.push_back({fired.rule, fired.seconds, {}});
    return m_bursts.back();
}

void RuleLog::add(const behavior::RuleFired& fired)
{
    Burst& burst = burstOf(fired);
    burst.last = fired.seconds;
    const auto [tally, isNew] = burst.people.try_emplace(fired.who);
    if (isNew) {
        tally->second.first = fired.seconds;
        ++m_tallies;
    }
    ++tally->second.count;
    tally->second.last = fired.seconds;
    forget();
}

void RuleLog::forget()
{
    while (m_bursts.size() > 1 && (m_bursts.size() > kMaxBursts || m_tallies > kMaxTallies)) {
        const auto oldest = std::ranges::min_element(m_bursts, {}, &Burst::last);
        m_tallies -= oldest->people.size();
        m_bursts.erase(oldest);
    }
}

QStringList RuleLog::lines(const model::Scene& scene,
                           const std::function<bool(model::IndividualId)>& isShown) const
{
    QStringList lines;
    for (const Burst& burst : m_bursts) {
        Sum sum;
        for (const auto& [who, tally] : burst.people) {
            if (isShown(who)) {
                sum.people.push_back(who);
                sum.least = std::min(sum.least, tally.count);
                sum.most = std::max(sum.most, tally.count);
                sum.all += tally.count;
                sum.first = std::min(sum.first, tally.first);
                sum.last = std::max(sum.last, tally.last);
            }
        }
        if (!sum.people.empty()) {
            const auto rule = std::ranges::find(scene.rules, burst.rule, &model::Rule::id);
            lines << lineText(sum, rule == scene.rules.end() ? RuleLogText::tr("a deleted rule")
                                                             : QString::fromStdString(rule->name));
        }
    }
    return lines;
}

} // namespace crowd::widgets
