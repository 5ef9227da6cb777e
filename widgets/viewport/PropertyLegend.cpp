// SPDX-License-Identifier: MIT
#include "widgets/viewport/PropertyLegend.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>
#include <QtGui/QGuiApplication>
#include <QtGui/QPainter>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "widgets/state/BrushTexts.h"
#include "widgets/state/FeatureTexts.h"

namespace crowd::widgets {

namespace {

constexpr int kLegendBorder = 12;
constexpr std::size_t kLegendRows = 14;
constexpr int kLegendSwatch = 12;

/// Dark on any picture and in any theme, like the other plates over it.
const QString kLegendStyle = QStringLiteral(R"(
#propertyLegend { background: rgba(20, 22, 26, 215); border: none; border-radius: 7px; }
#propertyLegend QLabel { color: rgb(170, 173, 180); background: transparent; }
#propertyLegend QToolButton { color: rgb(235, 236, 240); border: none; border-radius: 4px;
                              padding: 1px 6px 1px 2px; background: transparent; }
#propertyLegend QToolButton:hover { background: rgb(70, 72, 78); }
#propertyLegend QComboBox { color: rgb(235, 236, 240); background: rgb(48, 50, 56);
                            border: 1px solid rgb(92, 95, 102); border-radius: 4px;
                            padding: 2px 6px; }
#propertyLegend QComboBox QAbstractItemView { color: rgb(235, 236, 240);
                                              background: rgb(38, 40, 46);
                                              selection-background-color: rgb(90, 94, 104); }
)");

QIcon swatch(std::uint32_t color, double ratio)
{
    QPixmap drawn(QSize(kLegendSwatch, kLegendSwatch) * ratio);
    drawn.setDevicePixelRatio(ratio);
    drawn.fill(Qt::transparent);
    QPainter painter(&drawn);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QColor(255, 255, 255, 90));
    painter.setBrush(QColor::fromRgb(color));
    painter.drawRoundedRect(QRectF(0.5, 0.5, kLegendSwatch - 1.0, kLegendSwatch - 1.0), 3.0, 3.0);
    return drawn;
}

QString propertyName(const std::string& key)
{
    for (const model::ShownProperty& info : model::kShownProperties) {
        if (key == info.key) {
            return QCoreApplication::translate("Properties", info.label);
        }
    }
    if (const model::PropertyInfo* number = model::numberProperty(key)) {
        return fieldText(number->meta.label);
    }
    return featureText(key.substr(model::kFeatureProperty.size()));
}

/// "1.2–1.8 m".
QString rangeText(const model::PropertyClass& each, std::string_view unit)
{
    const QLocale locale;
    const auto number = [&locale](double value) { return locale.toString(value, 'f', 2); };
    const QString range = !std::isfinite(each.high) ? QStringLiteral("> ") + number(each.low)
                          : each.low < each.high
                              ? number(each.low) + QChar(0x2013) + number(each.high)
                              : number(each.low);
    const auto length = static_cast<qsizetype>(unit.size());
    return unit.empty() ? range : range + QLatin1Char(' ') + QString::fromUtf8(unit.data(), length);
}

} // namespace

model::CrowdFramePtr PropertyColours::painted(const EditorState& state,
                                              const model::CrowdFramePtr& frame)
{
    const std::string& key = state.viewOptions().property;
    const std::uint64_t version = frame->population.version();
    if (m_version == version && m_version != 0 && m_key == key) {
        auto painted = std::make_shared<model::CrowdFrame>(*frame);
        painted->population = m_people;
        return painted;
    }
    m_version = version;
    m_key = key;
    m_paint = model::paintBy(state.scene(), frame->population, key);
    auto painted = model::paintedFrame(*frame, m_paint);
    m_people = painted->population;
    return painted;
}

PropertyLegend::PropertyLegend(EditorState& state, PropertyColours& colours, QWidget* parent)
    : QFrame(parent), m_state(state), m_colours(colours), m_choice(new QComboBox(this)),
      m_rows(new QVBoxLayout), m_more(new QLabel(this))
{
    setObjectName(QStringLiteral("propertyLegend"));
    setStyleSheet(kLegendStyle);
    setAttribute(Qt::WA_NoMousePropagation); // else a click beside a row would paint
    m_choice->setObjectName(QStringLiteral("shownProperty"));
    m_choice->setFocusPolicy(Qt::NoFocus); // the keys stay the picture's
    m_choice->setToolTip(tr("What people are coloured by"));
    connect(m_choice, &QComboBox::activated, this, &PropertyLegend::choose);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(4);
    layout->addWidget(m_choice);
    m_rows->setSpacing(0);
    layout->addLayout(m_rows);
    m_more->setTextFormat(Qt::PlainText);
    layout->addWidget(m_more);
    hide();
}

void PropertyLegend::refresh()
{
    const bool isShown = render::lookInfo(m_state.viewOptions().look).isByProperty;
    if (isShown) {
        fillChoice();
        fillRows();
    }
    if (isShown != isVisibleTo(parentWidget())) {
        setVisible(isShown);
        place();
    }
}

void PropertyLegend::fillChoice()
{
    const std::vector<std::string> keys = model::propertyKeys(m_state.scene());
    if (keys != m_keys) {
        m_keys = keys;
        m_choice->clear();
        for (const std::string& key : m_keys) {
            m_choice->addItem(propertyName(key));
        }
    }
    const auto found = std::ranges::find(m_keys, m_state.viewOptions().property);
    m_choice->setCurrentIndex(found != m_keys.end() ? static_cast<int>(found - m_keys.begin()) : 0);
}

void PropertyLegend::choose(int index)
{
    if (index >= 0 && index < std::ssize(m_keys)) {
        ViewOptions options = m_state.viewOptions();
        options.property = m_keys[static_cast<std::size_t>(index)];
        m_state.setViewOptions(options);
    }
}

void PropertyLegend::fillRows()
{
    const model::PropertyPaint& paint = m_colours.paint();
    const std::size_t rows = std::min(paint.classes.size(), kLegendRows);
    QStringList texts;
    QString all;
    for (std::size_t i = 0; i < rows; ++i) {
        texts << textOf(paint.classes[i]);
        all += QString::number(paint.classes[i].color) + texts.back() + QLatin1Char('\n');
    }
    all += QString::number(paint.classes.size());
    if (all == m_shown) {
        return;
    }
    m_shown = all;
    while (m_buttons.size() < rows) {
        auto* button = new QToolButton(this);
        const std::size_t each = m_buttons.size();
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setIconSize({kLegendSwatch, kLegendSwatch});
        button->setFocusPolicy(Qt::NoFocus);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setToolTip(tr("Click: select them. Shift+click: select them as well."));
        connect(button, &QToolButton::clicked, this, [this, each] { select(each); });
        m_rows->addWidget(button);
        m_buttons.push_back(button);
    }
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        m_buttons[i]->setVisible(i < rows);
        if (i < rows) {
            m_buttons[i]->setIcon(swatch(paint.classes[i].color, devicePixelRatioF()));
            m_buttons[i]->setText(texts[static_cast<qsizetype>(i)]);
        }
    }
    m_more->setVisible(rows < paint.classes.size() || rows == 0);
    m_more->setText(
        rows == 0 ? tr("Nobody is there yet.")
                  : tr("and %n more", nullptr, static_cast<int>(paint.classes.size() - rows)));
    place();
}

QString PropertyLegend::textOf(const model::PropertyClass& each) const
{
    using Kind = model::PropertyClass::Kind;
    const bool isFeature = m_state.viewOptions().property.starts_with(model::kFeatureProperty);
    const QString name = [&] {
        switch (each.kind) {
        case Kind::Named:
            return isFeature ? featureText(each.name) : QString::fromStdString(each.name);
        case Kind::Tag:
            return tagText(m_state.scene(), static_cast<int>(each.number));
        case Kind::Unnamed:
            return tr("Group %1").arg(each.number);
        case Kind::Range:
            return rangeText(each, m_colours.paint().unit);
        case Kind::Several:
            return tr("several");
        case Kind::None:
            break;
        }
        return tr("none");
    }();
    return tr("%1 · %2").arg(name, QLocale().toString(static_cast<qulonglong>(each.people)));
}

void PropertyLegend::select(std::size_t each)
{
    std::vector<model::IndividualId> ids =
        model::peopleIn(m_colours.paint(), each, m_colours.people());
    std::erase_if(ids, [this](model::IndividualId id) {
        return m_state.scene().population.rowOf(id) == model::Population::npos;
    });
    if (QGuiApplication::keyboardModifiers().testFlag(Qt::ShiftModifier)) {
        const auto before = m_state.selection().ids();
        ids.insert(ids.end(), before.begin(), before.end());
        std::ranges::sort(ids);
        ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    }
    m_state.selection().set(ids);
}

void PropertyLegend::place()
{
    layout()->activate();
    const QSize size = sizeHint();
    setGeometry(kLegendBorder, parentWidget()->height() - size.height() - kLegendBorder,
                size.width(), size.height());
}

void PropertyLegend::renewTexts()
{
    m_keys.clear();
    m_shown.clear();
    m_choice->setToolTip(tr("What people are coloured by"));
    for (QToolButton* button : m_buttons) {
        button->setToolTip(tr("Click: select them. Shift+click: select them as well."));
    }
    refresh();
}

} // namespace crowd::widgets
