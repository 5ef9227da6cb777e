// SPDX-License-Identifier: MIT
#include "widgets/docks/LookPictures.h"

#include <algorithm>
#include <vector>

#include <QtGui/QPixmap>
#include <QtWidgets/QWidget>

#include "model/view/PropertyPaint.h"
#include "render/SceneLook.h"
#include "widgets/dialogs/TemplatePictures.h"
#include "widgets/state/EditorState.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kLookPictureMs = 250;          ///< from one picture to the next
constexpr int kMostLookTries = 40;           ///< while clips are still being computed
constexpr std::size_t kMostInLooks = 20'000; ///< people; more would hold up the artist

} // namespace

LookPictures::LookPictures(EditorState& state, QWidget& panel)
    : QObject(&panel), m_state(state), m_panel(panel)
{
    m_next.setSingleShot(true);
    m_next.setInterval(kLookPictureMs);
    connect(&m_next, &QTimer::timeout, this, &LookPictures::drawNext);
}

void LookPictures::forget()
{
    m_pictures.clear();
}

QIcon LookPictures::of(const model::LookPreset& look)
{
    Picture& picture = m_pictures[look.id];
    if (picture.look != look) {
        picture = {look, {}, 0};
    }
    if (picture.icon.isNull() && picture.tries < kMostLookTries) {
        m_next.start();
    }
    return picture.icon.isNull() ? iconNamed("look") : picture.icon;
}

void LookPictures::drawNext()
{
    if (!m_panel.isVisible()) {
        return;
    }
    const model::Looks& looks = m_state.scene().looks;
    const auto next = std::ranges::find_if(looks, [this](const model::LookPreset& each) {
        const auto known = m_pictures.find(each.id);
        return known != m_pictures.end() && known->second.look == each &&
               known->second.icon.isNull() && known->second.tries < kMostLookTries;
    });
    if (next == looks.end() || m_state.scene().population.size() > kMostInLooks) {
        return;
    }
    Picture& picture = m_pictures[next->id];
    bool isComplete = false;
    const QIcon icon = draw(*next, isComplete);
    ++picture.tries;
    if (isComplete || picture.tries == kMostLookTries) {
        picture.icon = icon;
        Q_EMIT drawn();
    }
    m_next.start();
}

QIcon LookPictures::draw(const model::LookPreset& look, bool& isComplete) const
{
    const double ratio = 2.0; // fine on any screen
    const glm::ivec2 pixels(static_cast<int>(kSize.width() * ratio),
                            static_cast<int>(kSize.height() * ratio));
    render::RenderInput input({m_state.camera(), glm::vec2(pixels)}, m_state.keyframes());
    input.frame = m_state.frame();
    if (look.style == model::LookStyle::Property) {
        input.frame = model::framePaintedBy(m_state.scene(), *input.frame, look.property);
    }
    input.pixelSize = pixels;
    input.stages = m_state.scene().stages;
    const std::vector<model::WorldSeat> seats = m_state.scene().worldSeats();
    input.seats = seats;
    input.lighting = m_state.scene().lighting;
    input.lights = m_state.scene().lights;
    render::useLook(input, look);
    input.lighting.showGroundGrid = false;
    QPixmap picture = QPixmap::fromImage(scenePicture(input, isComplete));
    picture.setDevicePixelRatio(ratio);
    QIcon icon(picture);
    icon.addPixmap(picture, QIcon::Selected); // not tinted
    return icon;
}

} // namespace crowd::widgets
