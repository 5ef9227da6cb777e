// SPDX-License-Identifier: MIT
#include "widgets/docks/StrokesDock.h"

#include <QtWidgets/QLabel>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/base/Random.h"
#include "model/brush/StrokeText.h"
#include "widgets/docks/BrushForm.h"
#include "widgets/forms/PanelButton.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

using model::BrushSettings;
using model::LastStrokes;

namespace {

constexpr int kLayMs = 40; ///< changes of a slider within it are laid together
constexpr int kListRows = 6;

} // namespace

StrokesDock::StrokesDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Strokes"), "strokes", parent), m_state(state), m_list(new QListWidget(this)),
      m_area(new QScrollArea(this)), m_note(new QLabel(this))
{
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setFixedHeight(kListRows * (fontMetrics().height() + 6));
    m_area->setFrameShape(QFrame::NoFrame);
    m_area->setWidgetResizable(true);
    m_area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_note->setObjectName(QStringLiteral("strokesNote"));
    m_note->setWordWrap(true);
    m_note->setMargin(4);
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(m_list);
    layout->addWidget(buttons());
    layout->addWidget(m_note);
    layout->addWidget(m_area, 1);
    setWidget(content);
    connectParts();
    refresh();
}

QWidget* StrokesDock::buttons()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](const char* icon, const QString& tip, auto act) {
        QToolButton* button = panelButton(row, icon, tip, icon);
        layout->addWidget(button);
        connect(button, &QToolButton::clicked, this, act);
        m_buttons << button;
    };
    add("reroll", tr("Draw everything random about this stroke anew"),
        [this] { set(m_settings, model::hashKeys(m_seed, 1)); });
    add("from-brush", tr("Lay this stroke with the brush as it is set now"), [this] {
        set(m_state.brush(m_settings.kind()), m_seed);
        rebuildForm();
    });
    add("to-brush", tr("Set the brush as it is set for this stroke"), [this] {
        m_state.setBrush(m_settings);
        m_state.setTool(toolOf(m_settings.kind()));
    });
    layout->addStretch(1);
    return row;
}

void StrokesDock::connectParts()
{
    m_refresh.setSingleShot(true);
    m_refresh.setInterval(0);
    connect(&m_refresh, &QTimer::timeout, this, &StrokesDock::refresh);
    connect(&m_state.strokes(), &LastStrokes::changed, &m_refresh, qOverload<>(&QTimer::start));
    m_lay.setSingleShot(true);
    m_lay.setInterval(kLayMs);
    connect(&m_lay, &QTimer::timeout, this, &StrokesDock::lay);
    connect(m_list, &QListWidget::currentRowChanged, this, [this](int row) {
        if (!m_isFilling) {
            choose(row);
        }
    });
}

void StrokesDock::showEvent(QShowEvent* event)
{
    DockBase::showEvent(event);
    refresh();
}

/// A new stroke is chosen; else the one that was.
void StrokesDock::refresh()
{
    if (!isVisible() || m_lay.isActive()) {
        return;
    }
    const int before = m_list->count();
    fillList();
    const auto count = static_cast<std::size_t>(m_list->count());
    const bool isSame = m_list->count() == before && m_chosen && *m_chosen < count &&
                        m_state.strokes().tail()[*m_chosen].stroke.settings == m_settings;
    if (!isSame) {
        const QSignalBlocker blocker(m_list);
        m_list->setCurrentRow(count > 0 ? 0 : -1);
        choose(m_list->currentRow());
    }
}

void StrokesDock::fillList()
{
    m_isFilling = true;
    const std::span<const LastStrokes::Entry> strokes = m_state.strokes().tail();
    const int row = m_list->currentRow();
    m_list->clear();
    for (auto stroke = strokes.rbegin(); stroke != strokes.rend(); ++stroke) {
        const BrushSettings& settings = stroke->stroke.settings;
        const QString text = model::strokeText(settings, stroke->affected);
        auto* item = new QListWidgetItem(iconNamed(toolInfo(toolOf(settings.kind())).stableId),
                                         stroke->step ? text : tr("%1: nobody now").arg(text));
        if (!stroke->step) {
            item->setForeground(palette().color(QPalette::Disabled, QPalette::Text));
        }
        m_list->addItem(item);
    }
    m_list->setCurrentRow(row < m_list->count() ? row : -1);
    m_isFilling = false;
}

void StrokesDock::choose(int row)
{
    const std::span<const LastStrokes::Entry> strokes = m_state.strokes().tail();
    m_chosen.reset();
    m_lay.stop();
    if (row >= 0 && static_cast<std::size_t>(row) < strokes.size()) {
        m_chosen = strokes.size() - 1 - static_cast<std::size_t>(row);
        m_settings = strokes[*m_chosen].stroke.settings;
        m_seed = strokes[*m_chosen].stroke.seed;
    }
    const bool isExact = !m_chosen || strokes[*m_chosen].stroke.isExact;
    m_note->setText(
        !m_chosen
            ? tr("The last strokes are listed here. Their settings can be changed until "
                 "something else is edited.")
            : tr("Whom this met depends on more than the scene: it was playing, clips were "
                 "still being loaded, or people got back what they had. They stay the ones it "
                 "met, until its area is changed."));
    m_note->setVisible(!m_chosen || !isExact);
    for (QToolButton* button : m_buttons) {
        button->setEnabled(m_chosen.has_value());
    }
    rebuildForm();
}

void StrokesDock::rebuildForm()
{
    delete m_area->takeWidget();
    m_form = nullptr;
    if (!m_chosen) {
        return;
    }
    const BrushTarget brush{[this]() -> const BrushSettings& { return m_settings; },
                            [this](const BrushSettings& settings) { set(settings, m_seed); }};
    m_form = makeBrushForm(m_state, brush, m_area);
    m_area->setWidget(m_form);
    m_form->show();
}

void StrokesDock::set(const BrushSettings& settings, std::uint64_t seed)
{
    if (!m_chosen) {
        return;
    }
    m_settings = settings;
    m_seed = seed;
    if (m_form != nullptr) {
        m_form->refresh();
    }
    m_lay.start();
}

void StrokesDock::lay()
{
    if (!m_chosen) {
        return;
    }
    const model::StrokeOutcome outcome = m_state.strokes().layAnew(*m_chosen, m_settings, m_seed);
    m_refresh.stop(); // the same strokes, with other numbers
    fillList();
    m_state.showStatus(
        outcome.isCommitted
            ? tr("Laid anew: %1").arg(model::strokeText(m_settings, outcome.affected))
            : outcome.message);
}

} // namespace crowd::widgets
