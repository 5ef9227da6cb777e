// SPDX-License-Identifier: MIT
#include "widgets/docks/ViewPictures.h"

#include <algorithm>
#include <vector>

#include <QtGui/QPixmap>

#include "widgets/dialogs/TemplatePictures.h"
#include "widgets/state/EditorState.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kPictureMs = 250;                ///< from one picture to the next
constexpr int kMostTries = 40;                 ///< while clips are still being computed
constexpr std::size_t kMostInPictures = 20000; ///< people; more would hold up the artist

} // namespace

ViewPictures::ViewPictures(EditorState& state, const QSize& size, const char* symbol,
                           QObject* parent)
    : QObject(parent), m_state(state), m_size(size), m_symbol(symbol)
{
    m_next.setSingleShot(true);
    m_next.setInterval(kPictureMs);
    connect(&m_next, &QTimer::timeout, this, &ViewPictures::drawNext);
}

void ViewPictures::forget()
{
    m_pictures.clear();
}

void ViewPictures::redraw(std::uint32_t id)
{
    const auto found = m_pictures.find(id);
    if (found != m_pictures.end()) {
        found->second.tries = 0;
        found->second.isDue = true;
    }
}

QIcon ViewPictures::pictureOf(std::uint32_t id)
{
    const Picture& picture = m_pictures[id];
    if (picture.isDue) {
        m_next.start();
    }
    return picture.icon.isNull() ? iconNamed(m_symbol) : picture.icon;
}

void ViewPictures::drawNext()
{
    const auto next =
        std::ranges::find_if(m_pictures, [](const auto& each) { return each.second.isDue; });
    if (next == m_pictures.end() || !isSeen() ||
        m_state.scene().population.size() > kMostInPictures) {
        return;
    }
    m_next.start();
    bool isComplete = false;
    const QIcon icon = draw(next->first, isComplete);
    if (icon.isNull()) {
        m_pictures.erase(next);
        return;
    }
    Picture& picture = next->second;
    ++picture.tries;
    if (isComplete || picture.tries == kMostTries) {
        picture.icon = icon;
        picture.isDue = false;
        Q_EMIT drawn();
    }
}

QIcon ViewPictures::draw(std::uint32_t id, bool& isComplete) const
{
    const double ratio = 2.0; // fine on any screen
    const glm::ivec2 pixels(static_cast<int>(m_size.width() * ratio),
                            static_cast<int>(m_size.height() * ratio));
    const model::Scene& scene = m_state.scene();
    render::RenderInput input({m_state.camera(), glm::vec2(pixels)}, m_state.keyframes());
    input.pixelSize = pixels;
    input.stages = scene.stages;
    const std::vector<model::WorldSeat> seats = scene.worldSeats();
    input.seats = seats;
    input.lighting = scene.lighting;
    input.lights = scene.lights;
    input.frame = frameOf(id, input);
    if (!input.frame) {
        return {};
    }
    input.lighting.showGroundGrid = false;
    QPixmap picture = QPixmap::fromImage(scenePicture(input, isComplete));
    picture.setDevicePixelRatio(ratio);
    QIcon icon(picture);
    icon.addPixmap(picture, QIcon::Selected); // not tinted
    return icon;
}

} // namespace crowd::widgets
