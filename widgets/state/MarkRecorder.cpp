// SPDX-License-Identifier: MIT
#include "widgets/state/MarkRecorder.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "model/document/SceneEdit.h"

namespace crowd::widgets {

namespace {

constexpr int kOneGoMs = 200;

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

void MarkRecorder::keep()
{
    if (m_performed.empty()) {
        return;
    }
    if (m_document.isEditOpen()) {
        m_keep.start(); // a stroke is under way
        return;
    }
    m_document.edit(tr("Record"), [this](model::SceneEdit& edit) {
        model::Timeline timeline = edit.scene().timeline;
        std::ranges::move(std::exchange(m_performed, {}), std::back_inserter(timeline));
        std::ranges::sort(timeline, {}, &model::Mark::id);
        edit.set<model::members::Timeline>(std::move(timeline));
    });
}

} // namespace crowd::widgets
