// SPDX-License-Identifier: MIT
#include "app/window/MemoryRelease.h"

#include <malloc.h>

namespace crowd::app {

namespace {

constexpr int kDelayMs = 3000; ///< longer than the last pictures of the old scene take

} // namespace

MemoryRelease::MemoryRelease(model::KeyframeStore& keyframes, QObject* parent)
    : QObject(parent), m_keyframes(keyframes)
{
    m_timer.setSingleShot(true);
    m_timer.setInterval(kDelayMs);
    connect(&m_timer, &QTimer::timeout, this, &MemoryRelease::release);
}

void MemoryRelease::plan()
{
    m_timer.start();
}

void MemoryRelease::release()
{
    m_keyframes.releaseUnused();
    // Loading works on many threads, each of which would keep what it got from the system.
    ::malloc_trim(0);
    if (m_keyframes.progress().pendingClips > 0) {
        m_timer.start(); // what is being baked may be the old scene's
    }
}

} // namespace crowd::app
