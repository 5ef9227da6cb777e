// SPDX-License-Identifier: MIT
#include "widgets/state/MarkRecorder.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "model/document/SceneEdit.h"
#include "widgets/state/Cues.h"

namespace crowd::widgets {

namespace {

constexpr int kOneGoMs = 200;

/// Downwards, so that nobody hears it a step later than he did.
int delayOf(const model::Mark& first, const model::Mark& later)
{
    const double milliseconds = (later.seconds - first.seconds) * 1000.0;
    return static_cast<int>(std::floor(milliseconds + 1e-6));
}

bool isSameEvent(const model::Mark& a, const model::Mark& b)
{
    return a.event == b.event && a.payload == b.payload;
}

/// What one mark says of people who hear the same event one after the other.
class SprayedEvent
{
public:
    explicit SprayedEvent(model::Mark first) : m_mark(std::move(first))
    {
        for (const int person : m_mark.people) {
            m_delays.emplace(person, 0);
        }
    }

    /// False: it is something else, or somebody hears it once more.
    [[nodiscard]] bool take(const model::Mark& later)
    {
        const int delay = delayOf(m_mark, later);
        const bool isPart =
            isSameEvent(m_mark, later) && delay >= 0 && delay <= model::kLatestDelay &&
            m_delays.size() + later.people.size() <= model::kMostMarkPeople &&
            std::ranges::none_of(later.people, [this](int id) { return m_delays.contains(id); });
        if (isPart) {
            for (const int person : later.people) {
                m_delays.emplace(person, delay);
            }
        }
        return isPart;
    }
    [[nodiscard]] model::Mark made() &&
    {
        const bool isAtOnce =
            std::ranges::all_of(m_delays, [](const auto& each) { return each.second == 0; });
        m_mark.people.clear();
        for (const auto& [person, delay] : m_delays) {
            m_mark.people.push_back(person);
            if (!isAtOnce) {
                m_mark.delays.push_back(delay);
            }
        }
        return std::move(m_mark);
    }

private:
    model::Mark m_mark;
    std::map<int, int> m_delays; ///< milliseconds, by person
};

bool isSprayed(const model::Mark& mark)
{
    return mark.kind == model::MarkKind::Event && !mark.people.empty();
}

/// What was performed in one go, with what was sprayed as one mark each.
model::Timeline gathered(model::Timeline performed)
{
    model::Timeline marks;
    std::vector<SprayedEvent> sprayed;
    for (model::Mark& mark : performed) {
        const auto part =
            isSprayed(mark) ? std::ranges::find_if(
                                  sprayed, [&mark](SprayedEvent& each) { return each.take(mark); })
                            : sprayed.end();
        if (!isSprayed(mark)) {
            marks.push_back(std::move(mark));
        } else if (part == sprayed.end()) {
            sprayed.emplace_back(std::move(mark));
        }
    }
    for (SprayedEvent& each : sprayed) {
        marks.push_back(std::move(each).made());
    }
    return marks;
}

} // namespace

MarkRecorder::MarkRecorder(model::SceneDocument& document, QObject* parent)
    : QObject(parent), m_document(document)
{
    m_keep.setSingleShot(true);
    m_keep.setInterval(kOneGoMs);
    connect(&m_keep, &QTimer::timeout, this, &MarkRecorder::keep);
}

void MarkRecorder::setOn(bool isOn)
{
    if (isOn != m_isOn) {
        m_isOn = isOn;
        Q_EMIT changed(isOn);
    }
}

model::MarkId MarkRecorder::nextId()
{
    const model::MarkId next = m_isOn ? model::freeMarkId(m_document.scene().timeline) : 0;
    if (next == 0) {
        return 0;
    }
    m_last = std::max(next, m_last + 1);
    return m_last;
}

void MarkRecorder::add(model::Timeline performed)
{
    if (!performed.empty()) {
        std::ranges::move(performed, std::back_inserter(m_performed));
        m_keep.start();
    }
}

void MarkRecorder::forget()
{
    m_performed.clear();
    m_last = 0;
}

/// What History says of it.
QString MarkRecorder::stepText(const model::Scene& scene, const model::Timeline& performed)
{
    const auto cue = std::ranges::find(scene.cues, performed.front().cue, &model::Cue::id);
    return performed.size() == 1 && cue != scene.cues.end()
               ? tr("Record “%1”").arg(cueTitle(scene, *cue))
               : tr("Record %n mark(s)", nullptr, static_cast<int>(performed.size()));
}

void MarkRecorder::keep()
{
    if (m_performed.empty()) {
        return;
    }
    if (m_document.isEditOpen()) {
        m_keep.start(); // a stroke is under way
        return;
    }
    m_isKeeping = true;
    model::Timeline performed = gathered(std::exchange(m_performed, {}));
    m_document.edit(stepText(m_document.scene(), performed), [&](model::SceneEdit& edit) {
        model::Timeline timeline = edit.scene().timeline;
        std::ranges::move(performed, std::back_inserter(timeline));
        std::ranges::sort(timeline, {}, &model::Mark::id);
        edit.set<model::members::Timeline>(std::move(timeline));
    });
    m_isKeeping = false;
}

} // namespace crowd::widgets
