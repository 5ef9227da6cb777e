// SPDX-License-Identifier: MIT
#include "widgets/viewport/BrushPopup.h"

#include <cmath>
#include <initializer_list>
#include <string_view>

#include <QtCore/QCoreApplication>
#include <QtCore/QSignalBlocker>
#include <QtGui/QIcon>
#include <QtGui/QPixmap>
#include <QtGui/QScreen>
#include <QtWidgets/QButtonGroup>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QSlider>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/project/PresetFolder.h"
#include "widgets/forms/NumberBox.h"
#include "widgets/state/BrushTexts.h"
#include "widgets/state/PresetUse.h"
#include "widgets/state/StoredColours.h"
#include "widgets/viewport/ToolIcons.h"

namespace crowd::widgets {

using model::BrushSettings;

namespace {

// The slider is logarithmic: as easy to set 8 pixels as 300.
constexpr int kSliderSteps = 200;
constexpr int kColumns = 7;     ///< of tools
constexpr int kPresetSize = 32; ///< logical pixels
constexpr int kColourSize = 22;

QString tipOf(model::BrushKind brush)
{
    return QCoreApplication::translate("Actions", model::brushType(brush).info.tip);
}

/// Without what it had; a new row is there at once, an old layout goes with its widgets.
QHBoxLayout* emptied(QWidget& row)
{
    qDeleteAll(row.findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
    delete row.layout();
    auto* layout = new QHBoxLayout(&row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    return layout;
}

int sliderOf(float radius)
{
    const double share = std::log(static_cast<double>(radius) / model::kMinRadiusPixels) /
                         std::log(model::kMaxRadiusPixels / model::kMinRadiusPixels);
    return qRound(share * kSliderSteps);
}

float radiusOf(int slider)
{
    const double share = static_cast<double>(slider) / kSliderSteps;
    return static_cast<float>(std::round(
        model::kMinRadiusPixels *
        std::pow(static_cast<double>(model::kMaxRadiusPixels / model::kMinRadiusPixels), share)));
}

/// A rate is one of sprays alone.
bool hasMainNumber(const BrushSettings& brush, const model::MainNumber& number)
{
    return brush.selection == model::BrushSelection::Spray ||
           std::string_view(number.label) != model::rateOf(brush).label;
}

void showEach(bool isVisible, std::initializer_list<QWidget*> widgets)
{
    for (QWidget* widget : widgets) {
        widget->setVisible(isVisible);
    }
}

} // namespace

BrushPopup::BrushPopup(EditorState& state, QWidget* parent)
    : QFrame(parent, Qt::Popup), m_state(state)
{
    setObjectName(QStringLiteral("brushPopup"));
    setFrameShape(QFrame::StyledPanel);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    layout->addWidget(makeTools());
    m_presets = new QWidget(this);
    m_presets->setObjectName(QStringLiteral("latestPresets"));
    layout->addWidget(m_presets);
    m_colours = new QWidget(this);
    m_colours->setObjectName(QStringLiteral("latestColours"));
    layout->addWidget(m_colours);
    layout->addWidget(makeSettings());
    connect(&state, &EditorState::brushChanged, this, &BrushPopup::refresh);
    connect(&state, &EditorState::toolChanged, this, &BrushPopup::refresh);
    refresh();
}

QWidget* BrushPopup::makeTools()
{
    auto* box = new QWidget(this);
    m_toolGrid = box;
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(2);
    m_tools = new QButtonGroup(box);
    for (const ToolInfo& info : toolTable()) {
        auto* button = new QToolButton(box);
        const QString id = QLatin1String(info.stableId);
        const QString name = toolName(info.id);
        button->setObjectName(id);
        button->setIcon(toolIcon(info.id));
        button->setIconSize({28, 28});
        button->setText(name);
        button->setToolButtonStyle(button->icon().isNull() ? Qt::ToolButtonTextOnly
                                                           : Qt::ToolButtonIconOnly);
        const QString title = tr("%1 (%2)").arg(name, QLatin1String(info.shortcut));
        button->setToolTip(info.brush ? title + QLatin1Char('\n') + tipOf(*info.brush) : title);
        button->setCheckable(true);
        button->setAutoRaise(true);
        m_tools->addButton(button, static_cast<int>(info.id));
        const int at = grid->count();
        grid->addWidget(button, at / kColumns, at % kColumns);
    }
    connect(m_tools, &QButtonGroup::idClicked, this, [this](int id) {
        close();
        m_state.setTool(static_cast<ToolId>(id));
    });
    return box;
}

/// Those that are still there.
void BrushPopup::fillPresets()
{
    QHBoxLayout* row = emptied(*m_presets);
    const model::PresetFolder folder(model::presetFolder());
    for (const QString& name : latestPresets()) {
        const model::BrushPreset* found = folder.find(name);
        if (found == nullptr) {
            continue;
        }
        auto* button = new QToolButton(m_presets);
        button->setIcon(presetPicture(*found));
        button->setIconSize({kPresetSize, kPresetSize});
        button->setToolTip(name);
        button->setAutoRaise(true);
        row->addWidget(button);
        connect(button, &QToolButton::clicked, this, [this, preset = *found] {
            close();
            usePreset(m_state, preset);
        });
    }
    m_presets->setVisible(row->count() > 0);
    row->addStretch(1);
}

void BrushPopup::fillColours()
{
    QHBoxLayout* row = emptied(*m_colours);
    for (const QColor& color : storedColours(kRecentColours)) {
        auto* button = new QToolButton(m_colours);
        QPixmap square(kColourSize, kColourSize);
        square.fill(color);
        button->setIcon(square);
        button->setIconSize(square.size());
        button->setToolTip(color.name());
        button->setAutoRaise(true);
        row->addWidget(button);
        connect(button, &QToolButton::clicked, this, [this, color] { paintWith(color); });
    }
    const bool hasAny = row->count() > 0;
    row->addStretch(1);
    m_colours->setVisible(hasAny && m_state.tool() == ToolId::BrushColour);
}

void BrushPopup::paintWith(const QColor& color)
{
    change([&color](BrushSettings settings) {
        if (auto* colour = settings.find<model::ColourSettings>()) {
            colour->colors.front() = {static_cast<std::uint8_t>(color.red()),
                                      static_cast<std::uint8_t>(color.green()),
                                      static_cast<std::uint8_t>(color.blue())};
        }
        return settings;
    });
    close();
}

QWidget* BrushPopup::makeSettings()
{
    m_settings = new QWidget(this);
    auto* grid = new QGridLayout(m_settings);
    grid->setContentsMargins(0, 0, 0, 0);
    m_selectionText = new QLabel(tr("Area"), m_settings);
    m_sizeTitle = new QLabel(tr("Size"), m_settings);
    m_selection = new QComboBox(m_settings);
    for (int kind = 0; kind < static_cast<int>(std::size(model::kSelections)); ++kind) {
        m_selection->addItem(selectionName(static_cast<model::BrushSelection>(kind)));
    }
    m_selection->setObjectName(QStringLiteral("area"));
    m_size = new QSlider(Qt::Horizontal, m_settings);
    m_size->setObjectName(QStringLiteral("size"));
    m_size->setRange(0, kSliderSteps);
    m_sizeText = new QLabel(m_settings);
    m_sizeText->setMinimumWidth(fontMetrics().horizontalAdvance(tr("%1 px").arg(1000)));
    m_numberText = new QLabel(m_settings);
    m_number = new NumberBox(m_settings);
    m_number->setObjectName(QStringLiteral("mainNumber"));
    grid->addWidget(m_selectionText, 0, 0);
    grid->addWidget(m_selection, 0, 1, 1, 2);
    grid->addWidget(m_sizeTitle, 1, 0);
    grid->addWidget(m_size, 1, 1);
    grid->addWidget(m_sizeText, 1, 2);
    grid->addWidget(m_numberText, 2, 0);
    grid->addWidget(m_number, 2, 1, 1, 2);
    connect(m_selection, &QComboBox::currentIndexChanged, this, [this](int index) {
        change([index](BrushSettings settings) {
            settings.selection = static_cast<model::BrushSelection>(index);
            return settings;
        });
    });
    connect(m_size, &QSlider::valueChanged, this, [this](int value) {
        change([value](const BrushSettings& settings) {
            return settings.resized(radiusOf(value) - settings.radiusPixels);
        });
    });
    connect(m_number, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        change([value](const BrushSettings& settings) { return settings.withMainNumber(value); });
    });
    return m_settings;
}

void BrushPopup::change(const std::function<BrushSettings(const BrushSettings&)>& how)
{
    const BrushSettings* brush = m_state.activeBrush();
    if (!m_isRefreshing && brush != nullptr) {
        m_state.setBrush(how(*brush));
    }
}

void BrushPopup::refresh()
{
    m_isRefreshing = true;
    m_tools->button(static_cast<int>(m_state.tool()))->setChecked(true);
    const BrushSettings* brush = m_state.activeBrush();
    m_settings->setVisible(brush != nullptr);
    if (brush != nullptr) {
        refreshSettings(*brush);
    }
    m_isRefreshing = false;
}

/// Those that it has, as in its panel.
void BrushPopup::refreshSettings(const BrushSettings& brush)
{
    m_selection->setCurrentIndex(static_cast<int>(brush.selection));
    showEach(!brush.addsPlaces(), {m_selectionText, m_selection});
    if (radiusOf(m_size->value()) != brush.radiusPixels) {
        m_size->setValue(sliderOf(brush.radiusPixels));
    }
    m_sizeText->setText(tr("%1 px").arg(qRound(brush.radiusPixels)));
    showEach(brush.hasCircle(), {m_sizeTitle, m_size, m_sizeText});
    const model::MainNumber number = brush.mainNumber();
    m_numberText->setText(mainNumberName(number));
    m_number->setDecimals(number.decimals);
    m_number->setRange(number.low, number.high);
    m_number->setSingleStep(number.step);
    m_number->setValue(number.value);
    showEach(hasMainNumber(brush, number), {m_numberText, m_number});
}

void BrushPopup::popUp(const QPoint& globalPosition)
{
    for (const ToolInfo& info : toolTable()) {
        m_tools->button(static_cast<int>(info.id))->setIcon(toolIcon(info.id)); // the theme's
    }
    fillPresets();
    fillColours();
    refresh();
    m_settings->layout()->activate(); // of the rows that are there now
    adjustSize();
    layout()->activate();
    m_toolGrid->layout()->setGeometry(m_toolGrid->rect());
    const QWidget* inHand = m_tools->button(static_cast<int>(m_state.tool()));
    QRect place({}, size());
    place.moveTopLeft(globalPosition - inHand->mapTo(this, inHand->rect().center()));
    const QRect area = parentWidget()->screen()->availableGeometry();
    place.moveLeft(
        std::clamp(place.left(), area.left(), std::max(area.left(), area.right() - place.width())));
    place.moveTop(
        std::clamp(place.top(), area.top(), std::max(area.top(), area.bottom() - place.height())));
    move(place.topLeft());
    show();
}

} // namespace crowd::widgets
