// SPDX-License-Identifier: MIT
#include "widgets/state/PathFocus.h"

#include <algorithm>

#include "widgets/state/SceneChanges.h"

namespace crowd::widgets {

PathFocus::PathFocus(model::SceneDocument& document, QObject* parent)
    : QObject(parent), m_document(document)
{
    connect(&document, &model::SceneDocument::changed, this, &PathFocus::follow);
    connect(&document, &model::SceneDocument::stepTaken, this, &PathFocus::takeBack);
    // What is new may have got the number of what was undone.
    connect(&document, &model::SceneDocument::stepCommitted, this, [this] {
        const model::Scene& scene = m_document.scene();
        m_gonePath = scene.findPath(m_gonePath) != nullptr ? 0 : m_gonePath;
        std::erase_if(m_gone,
                      [&scene](model::PlaceId place) { return scene.findPlace(place) != nullptr; });
    });
}

void PathFocus::paint(model::PathId path)
{
    m_gonePath = 0;
    m_path = path;
    m_isPainting = path != 0;
    Q_EMIT changed();
}

void PathFocus::look(model::PathId path)
{
    if (m_path == path) {
        return;
    }
    m_gonePath = 0;
    m_path = path;
    m_isPainting = false;
    Q_EMIT changed();
}

void PathFocus::end()
{
    if (m_isPainting || m_shaped != 0) {
        m_isPainting = false;
        m_shaped = 0;
        Q_EMIT changed();
    }
}

void PathFocus::shape(model::PlaceId place)
{
    if (m_shaped != place) {
        m_shaped = place;
        Q_EMIT changed();
    }
}

bool PathFocus::isSelected(model::PlaceId place) const
{
    return std::find(m_places.begin(), m_places.end(), place) != m_places.end();
}

void PathFocus::select(std::vector<model::PlaceId> places)
{
    m_gone.clear();
    if (m_places != places) {
        m_places = std::move(places);
        Q_EMIT changed();
    }
}

void PathFocus::toggle(model::PlaceId place)
{
    std::vector<model::PlaceId> places = m_places;
    if (isSelected(place)) {
        std::erase(places, place);
    } else {
        places.push_back(place);
    }
    select(std::move(places));
}

void PathFocus::follow(const model::SceneChange& change)
{
    if (!isOneOf<model::PathsChanged, model::SceneReplaced>(change)) {
        return;
    }
    std::vector<model::PlaceId> places;
    for (const model::PlaceId place : m_places) {
        const bool isThere = m_document.scene().findPlace(place) != nullptr;
        (isThere ? places : m_gone).push_back(place);
    }
    const bool isPathGone = m_path != 0 && m_document.scene().findPath(m_path) == nullptr;
    if (isPathGone) {
        m_gonePath = m_path;
        m_path = 0;
        m_isPainting = false;
    }
    const bool isShapedGone = m_shaped != 0 && m_document.scene().findPlace(m_shaped) == nullptr;
    m_shaped = isShapedGone ? 0 : m_shaped;
    if (isPathGone || isShapedGone || places != m_places) {
        m_places = std::move(places);
        Q_EMIT changed();
    }
}

/// A step was undone or done again: what it brought back is chosen as it was.
void PathFocus::takeBack()
{
    const model::Scene& scene = m_document.scene();
    if (m_gonePath != 0 && scene.findPath(m_gonePath) != nullptr) {
        look(m_gonePath);
    }
    std::vector<model::PlaceId> back;
    std::vector<model::PlaceId> gone;
    for (const model::PlaceId place : m_gone) {
        (scene.findPlace(place) != nullptr ? back : gone).push_back(place);
    }
    if (!back.empty()) {
        back.insert(back.end(), m_places.begin(), m_places.end());
        select(std::move(back));
        m_gone = std::move(gone);
    }
}

} // namespace crowd::widgets
