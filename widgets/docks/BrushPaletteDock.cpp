// SPDX-License-Identifier: MIT
#include "widgets/docks/BrushPaletteDock.h"

#include <algorithm>
#include <utility>

#include <QtCore/QCoreApplication>
#include <QtCore/QEvent>
#include <QtGui/QKeySequence>
#include <QtGui/QPainter>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QToolButton>

#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kIconSize = 24;
constexpr int kSpacing = 3;
constexpr int kMargin = 5;
constexpr int kRowsAtLeast = 5;

QString tipOf(const ScriptBrush& brush)
{
    const QString name = QString::fromStdString(brush.settings.as<model::ScriptSettings>().brush);
    return brush.tip.isEmpty() ? name : QStringLiteral("%1\n%2").arg(name, brush.tip);
}

/// A script's brush has no picture of its own: its first letters tell it from the others.
QIcon scriptBrushIcon(const std::string& name)
{
    constexpr int kScale = 2;
    QPixmap picture(kIconSize * kScale, kIconSize * kScale);
    picture.setDevicePixelRatio(kScale);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0x5a, 0xa4, 0x69));
    painter.drawRoundedRect(QRectF(1.0, 1.0, kIconSize - 2.0, kIconSize - 2.0), 5.0, 5.0);
    QFont font = painter.font();
    font.setPixelSize(12);
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(Qt::white);
    painter.drawText(QRect(0, 0, kIconSize, kIconSize), Qt::AlignCenter,
                     QString::fromStdString(name).left(2));
    return QIcon(picture);
}

} // namespace

BrushPaletteDock::BrushPaletteDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Brushes"), "brushPalette", parent), m_state(state),
      m_area(new QScrollArea(this)), m_content(new QWidget(this)),
      m_grid(new QGridLayout(m_content))
{
    m_area->setFrameShape(QFrame::NoFrame);
    m_area->setWidgetResizable(true);
    m_area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_area->setWidget(m_content);
    m_grid->setSpacing(kSpacing);
    m_grid->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    for (const ToolInfo& info : toolTable()) {
        const QString name = QCoreApplication::translate("Tools", info.name);
        const QString keys = QKeySequence(QLatin1String(info.shortcut), QKeySequence::PortableText)
                                 .toString(QKeySequence::NativeText);
        QToolButton* button =
            addButton(name, keys.isEmpty() ? name : QStringLiteral("%1  (%2)").arg(name, keys));
        button->setObjectName(QLatin1String(info.stableId));
        const ToolId id = info.id;
        connect(button, &QToolButton::clicked, this, [this, id] {
            m_state.setTool(id);
            refresh(); // a click on the active tool must not uncheck it
        });
        m_buttons[static_cast<std::size_t>(id)] = button;
    }
    setWidget(m_area);
    connect(&m_state, &EditorState::toolChanged, this, &BrushPaletteDock::refresh);
    connect(&m_state, &EditorState::scriptBrushesChanged, this,
            &BrushPaletteDock::rebuildScriptBrushes);
    rebuildScriptBrushes();
    refreshIcons();
    refresh();
    arrange(sizeHint().width());
}

QToolButton* BrushPaletteDock::addButton(const QString& name, const QString& tip)
{
    auto* button = new QToolButton(m_content);
    button->setToolTip(tip);
    button->setAccessibleName(name);
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setIconSize({kIconSize, kIconSize});
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return button;
}

/// Each has a button of its own; as long as there are none, one says what they are.
void BrushPaletteDock::rebuildScriptBrushes()
{
    const auto& brushes = m_state.scriptBrushes();
    const bool isSame = std::ranges::equal(
        brushes, m_scriptButtons, {}, [](const ScriptBrush& brush) { return tipOf(brush); },
        [](const QToolButton* button) { return button->toolTip(); });
    if (isSame) {
        refresh(); // another one was chosen, perhaps by one of the buttons
        return;
    }
    qDeleteAll(std::exchange(m_scriptButtons, {}));
    for (const ScriptBrush& brush : brushes) {
        const std::string name = brush.settings.as<model::ScriptSettings>().brush;
        QToolButton* button = addButton(QString::fromStdString(name), tipOf(brush));
        button->setObjectName(QStringLiteral("script-brush/%1").arg(QString::fromStdString(name)));
        connect(button, &QToolButton::clicked, this, [this, name] {
            m_state.chooseScriptBrush(name);
            m_state.setTool(ToolId::BrushScript);
            refresh();
        });
        button->show();
        m_scriptButtons.push_back(button);
    }
    m_buttons[static_cast<std::size_t>(ToolId::BrushScript)]->setVisible(m_scriptButtons.empty());
    m_columns = 0;
    arrange(width());
    refreshIcons();
    refresh();
}

std::vector<QToolButton*> BrushPaletteDock::shownButtons() const
{
    std::vector<QToolButton*> shown;
    for (const ToolInfo& info : toolTable()) {
        if (info.id == ToolId::BrushScript && !m_scriptButtons.empty()) {
            shown.insert(shown.end(), m_scriptButtons.begin(), m_scriptButtons.end());
        } else {
            shown.push_back(m_buttons[static_cast<std::size_t>(info.id)]);
        }
    }
    return shown;
}

void BrushPaletteDock::arrange(int width)
{
    const std::vector<QToolButton*> shown = shownButtons();
    const QSize cell = m_buttons.front()->sizeHint();
    const int fitting = (width - 2 * kMargin + kSpacing) / (cell.width() + kSpacing);
    const int count = static_cast<int>(shown.size());
    const int columns = std::clamp(fitting, 1, count);
    if (columns == m_columns) {
        return;
    }
    m_columns = columns;
    for (int i = 0; i < count; ++i) {
        m_grid->addWidget(shown[static_cast<std::size_t>(i)], i / columns, i % columns);
    }
    const int rows = (count + columns - 1) / columns;
    const auto heightOf = [&](int some) {
        return some * (cell.height() + kSpacing) - kSpacing + 2 * kMargin;
    };
    m_content->setFixedHeight(heightOf(rows));
    // Whole where there is room. While the window is laid out the panel may be so narrow that all
    // stand in one column, and a window that has grown for that does not shrink again.
    m_area->setMinimumHeight(heightOf(std::min(rows, kRowsAtLeast)));
    m_area->setMaximumHeight(heightOf(rows));
    m_area->setMinimumWidth(std::min(4, count) * (cell.width() + kSpacing));
}

void BrushPaletteDock::resizeEvent(QResizeEvent* event)
{
    DockBase::resizeEvent(event);
    arrange(width());
}

void BrushPaletteDock::refresh()
{
    for (const ToolInfo& info : toolTable()) {
        m_buttons[static_cast<std::size_t>(info.id)]->setChecked(info.id == m_state.tool());
    }
    const std::string& chosen =
        m_state.brush(model::BrushKind::Script).as<model::ScriptSettings>().brush;
    for (std::size_t i = 0; i < m_scriptButtons.size(); ++i) {
        m_scriptButtons[i]->setChecked(
            m_state.tool() == ToolId::BrushScript &&
            m_state.scriptBrushes()[i].settings.as<model::ScriptSettings>().brush == chosen);
    }
}

void BrushPaletteDock::refreshIcons()
{
    for (const ToolInfo& info : toolTable()) {
        m_buttons[static_cast<std::size_t>(info.id)]->setIcon(iconNamed(info.stableId));
    }
    for (std::size_t i = 0; i < m_scriptButtons.size(); ++i) {
        m_scriptButtons[i]->setIcon(
            scriptBrushIcon(m_state.scriptBrushes()[i].settings.as<model::ScriptSettings>().brush));
    }
}

void BrushPaletteDock::changeEvent(QEvent* event)
{
    DockBase::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        refreshIcons();
    }
}

} // namespace crowd::widgets
