// SPDX-License-Identifier: MIT
#include "widgets/docks/StatePictures.h"

#include <algorithm>

#include "model/states/StateKeeping.h"
#include "widgets/dialogs/TemplatePictures.h"
#include "widgets/state/EditorState.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kPictureMs = 250;                ///< from one picture to the next
constexpr int kMostTries = 40;                 ///< while clips are still being computed
constexpr std::size_t kMostInPictures = 20000; ///< people; more would hold up the artist

} // namespace

StatePictures::StatePictures(EditorState& state, QObject* parent) : QObject(parent), m_state(state)
{
    m_next.setSingleShot(true);
    m_next.setInterval(kPictureMs);
    connect(&m_next, &QTimer::timeout, this, &StatePictures::drawNext);
}

void StatePictures::forget()
{
    m_pictures.clear();
}

QIcon StatePictures::of(const model::State& kept)
{
    Picture& picture = m_pictures[kept.id];
    if (picture.people != kept.people) {
        picture = {kept.people, {}, 0};
    }
    if (picture.icon.isNull() && picture.tries < kMostTries) {
        m_next.start();
    }
    return picture.icon.isNull() ? iconNamed("state") : picture.icon;
}

void StatePictures::drawNext()
{
    const auto& states = m_state.scene().states;
    const auto next = std::ranges::find_if(states, [this](const model::State& each) {
        const auto known = m_pictures.find(each.id);
        return known != m_pictures.end() && known->second.people == each.people &&
               known->second.icon.isNull() && known->second.tries < kMostTries;
    });
    if (next == states.end() || m_state.scene().population.size() > kMostInPictures) {
        return;
    }
    Picture& picture = m_pictures[next->id];
    bool isComplete = false;
    const QIcon icon = draw(*next, isComplete);
    ++picture.tries;
    if (isComplete || picture.tries == kMostTries) {
        picture.icon = icon;
        Q_EMIT drawn();
    }
    m_next.start();
}

QIcon StatePictures::draw(const model::State& kept, bool& isComplete) const
{
    model::Scene scene = m_state.scene();
    (void)recallState(scene, kept, kept.columns);
    const double ratio = 2.0; // fine on any screen
    const glm::ivec2 pixels(static_cast<int>(kSize.width() * ratio),
                            static_cast<int>(kSize.height() * ratio));
    render::RenderInput input({m_state.camera(), glm::vec2(pixels)}, m_state.keyframes());
    model::CrowdFrame frame = *m_state.document().frame(m_state.transport().seconds());
    frame.population = scene.population;
    input.frame = std::make_shared<const model::CrowdFrame>(std::move(frame));
    input.pixelSize = pixels;
    input.stages = scene.stages;
    const std::vector<model::WorldSeat> seats = scene.worldSeats();
    input.seats = seats;
    input.lighting = scene.lighting;
    input.lights = scene.lights;
    input.lighting.showGroundGrid = false;
    input.look = m_state.viewOptions().look;
    QPixmap picture = QPixmap::fromImage(scenePicture(input, isComplete));
    picture.setDevicePixelRatio(ratio);
    QIcon icon(picture);
    icon.addPixmap(picture, QIcon::Selected); // not tinted
    return icon;
}

} // namespace crowd::widgets
