// SPDX-License-Identifier: MIT
#include "widgets/docks/FeaturePreview.h"

#include <algorithm>

#include <QtGui/QPainter>

#include "model/brush/ClipChoice.h"
#include "model/features/FeatureLook.h"
#include "model/features/FeatureWriting.h"
#include "widgets/dialogs/TemplatePictures.h"

namespace crowd::widgets {

namespace {

constexpr int kFeatureBeatMs = 100;
constexpr int kStanding = 3;
constexpr int kShownPeople = 6;
constexpr float kApart = 0.85F; ///< metres
constexpr float kSeatHeight = 0.45F;
constexpr std::uint64_t kPreviewSeed = 11;

/// Templates that the value is for, those that it does something to first.
std::vector<const model::TemplateEntry*> castFor(const model::Scene& scene,
                                                 const model::FeatureValue& value)
{
    std::vector<const model::TemplateEntry*> cast;
    std::vector<const model::TemplateEntry*> others;
    for (const model::TemplateEntry& entry : scene.templates) {
        const model::FeatureLook look(value, entry);
        const bool moves = !look.standing.empty() || !look.seated.empty();
        const bool dresses = std::ranges::any_of(look.slots, [](const auto& slot) {
            return slot.colors != nullptr || !slot.materials.empty();
        });
        if (entry.asset && look.isMeant) {
            (moves || dresses ? cast : others).push_back(&entry);
        }
    }
    return cast.empty() ? others : cast;
}

model::IndividualRows peopleOf(const std::vector<const model::TemplateEntry*>& cast,
                               std::vector<model::WorldSeat>& seats)
{
    auto rows = model::IndividualRows::withDefaults({1, 2, 3, 4, 5, 6});
    for (std::size_t i = 0; i < kShownPeople; ++i) {
        const model::TemplateEntry& entry = *cast[i % cast.size()];
        const bool sits = i >= kStanding;
        const float x = kApart * (static_cast<float>(i) - 0.5F * (kShownPeople - 1));
        rows.column(model::columns::templateId)[i] = entry.id;
        rows.column(model::columns::position)[i] = {x, 0.0F, 0.0F};
        rows.column(model::columns::parts)[i] = model::defaultParts(*entry.asset);
        rows.column(model::columns::clip)[i] = model::usualClip(entry, sits);
        if (sits) {
            model::WorldSeat seat;
            seat.id = static_cast<model::SeatId>(i);
            seat.seat.position = {x, 0.0F, 0.0F};
            seat.seat.height = kSeatHeight;
            rows.column(model::columns::seat)[i] = seat.id;
            seats.push_back(seat);
        }
    }
    return rows;
}

} // namespace

FeaturePreview::FeaturePreview(EditorState& state, QWidget* parent)
    : QWidget(parent), m_state(state)
{
    setObjectName(QStringLiteral("featurePreview"));
    setMinimumHeight(110);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&m_clock, &QTimer::timeout, this, &FeaturePreview::beat);
    m_clock.start(kFeatureBeatMs);
}

void FeaturePreview::setFeature(const model::FeatureValue* value)
{
    m_people = {};
    m_seats.clear();
    ++m_seatsVersion;
    const auto cast = value != nullptr ? castFor(m_state.scene(), *value)
                                       : std::vector<const model::TemplateEntry*>();
    if (!cast.empty()) {
        m_people.templates = m_state.scene().templates;
        m_people.population.add(peopleOf(cast, m_seats));
        model::FeatureKind kind;
        kind.id = 1;
        kind.values = {*value};
        const auto ids = m_people.population.ids();
        const std::vector<model::FeatureId> wanted(ids.size(), value->id);
        for (const model::ChangedColumn& each :
             featureChanges(m_people, kind, ids, wanted, kPreviewSeed)) {
            m_people.population.setValues(each.column, each.ids, each.bytes);
        }
    }
    update();
}

void FeaturePreview::beat()
{
    if (isVisible() && !visibleRegion().isEmpty() && !m_people.population.isEmpty()) {
        m_seconds += kFeatureBeatMs / 1000.0;
        update();
    }
}

QImage FeaturePreview::picture() const
{
    const double ratio = devicePixelRatioF();
    const glm::vec2 size(width(), height());
    const auto camera = model::Camera::lookingAt({0.0F, 1.7F, 5.2F}, {0.0F, 0.85F, 0.0F});
    model::Camera fitting = camera;
    const float aspect = size.x / std::max(size.y, 1.0F);
    const float halfWidth = 0.5F * kApart * kShownPeople + 0.25F;
    const float wanted = 2.0F * std::atan(std::max(1.25F, halfWidth / aspect) / 5.2F);
    fitting.fovYRadians = std::min(wanted, 1.6F);
    render::RenderInput input({fitting, size}, m_state.keyframes());
    model::CrowdFrame frame;
    frame.population = m_people.population;
    frame.templates = std::make_shared<const std::vector<model::TemplateEntry>>(m_people.templates);
    frame.seconds = m_seconds;
    input.frame = std::make_shared<const model::CrowdFrame>(std::move(frame));
    input.pixelSize = {static_cast<int>(size.x * static_cast<float>(ratio)),
                       static_cast<int>(size.y * static_cast<float>(ratio))};
    input.seats = m_seats;
    input.seatsVersion = m_seatsVersion;
    input.showGround = false;
    const QColor base = palette().color(QPalette::Base);
    input.background = {base.redF(), base.greenF(), base.blueF(), 1.0F};
    bool isComplete = false;
    QImage picture = scenePicture(input, isComplete);
    picture.setDevicePixelRatio(ratio);
    return picture;
}

void FeaturePreview::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    if (m_people.population.isEmpty()) {
        painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
        painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Nobody of the scene's templates can show it."));
        return;
    }
    painter.drawImage(QPointF(), picture());
}

} // namespace crowd::widgets
