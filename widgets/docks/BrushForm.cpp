// SPDX-License-Identifier: MIT
#include "widgets/docks/BrushForm.h"

#include <algorithm>

#include <QtCore/QSettings>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QColorDialog>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QToolButton>

#include "model/brush/ClipChoice.h"
#include "widgets/docks/ClipMix.h"
#include "widgets/docks/CurveEditor.h"
#include "widgets/docks/NumberList.h"
#include "widgets/docks/RangeSlider.h"

namespace crowd::widgets {

namespace {

QWidget* labelled(const QString& label, QWidget* control, QWidget* parent)
{
    auto* row = new QWidget(parent);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* text = new QLabel(label, row);
    text->setBuddy(control);
    layout->addWidget(text);
    layout->addWidget(control, 1);
    return row;
}

/// Each name once, in the order of the templates.
/// Each once; those to walk with, or all.
std::vector<std::string> clipNamesOf(const model::Scene& scene, ClipsOnOffer offer)
{
    std::vector<std::string> names;
    for (const model::TemplateEntry& entry : scene.templates) {
        for (std::size_t i = 0; i < entry.clipNames.size(); ++i) {
            const int index = entry.asset ? entry.asset->clipIndex(entry.clipNames[i]) : -1;
            const bool isMeant =
                offer == ClipsOnOffer::All ||
                (index >= 0 && model::movesOverGround(entry, i, static_cast<std::size_t>(index)));
            if (isMeant && std::ranges::find(names, entry.clipNames[i]) == names.end()) {
                names.push_back(entry.clipNames[i]);
            }
        }
    }
    return names;
}

} // namespace

BrushForm::BrushForm(EditorState& state, model::BrushKind kind, QWidget* parent)
    : QWidget(parent), m_state(state), m_kind(kind), m_layout(new QVBoxLayout(this))
{
    m_layout->setSpacing(4);
    m_layout->setContentsMargins(6, 4, 6, 6);
}

template<class Change>
void BrushForm::change(const Change& apply)
{
    if (m_isRefreshing) {
        return;
    }
    Settings settings = m_state.brush(m_kind);
    apply(settings);
    m_state.setBrush(settings);
}

void BrushForm::bind(QWidget* row, std::function<void(const Settings&)> refresh, Condition isShown)
{
    if (m_row != nullptr) {
        m_row->addWidget(row, 1);
    } else {
        m_layout->addWidget(row);
    }
    m_rows.push_back(
        {row, std::move(refresh), std::move(isShown), static_cast<int>(m_sections.size()) - 1});
}

void BrushForm::refresh()
{
    m_isRefreshing = true;
    for (const Row& row : m_rows) {
        row.refresh(m_state.brush(m_kind));
    }
    refreshVisibility();
    m_isRefreshing = false;
}

void BrushForm::refreshVisibility()
{
    const Settings& settings = m_state.brush(m_kind);
    std::vector<bool> isUsed(m_sections.size(), false);
    for (const Row& row : m_rows) {
        const bool matters = !row.isShown || row.isShown(settings);
        const auto section = static_cast<std::size_t>(row.section);
        const bool isFolded = row.section >= 0 && !m_sections[section].isOpen;
        row.widget->setVisible(matters && !isFolded);
        if (row.section >= 0 && matters) {
            isUsed[section] = true;
        }
    }
    for (std::size_t i = 0; i < m_sections.size(); ++i) {
        m_sections[i].header->setVisible(isUsed[i]);
    }
    for (QWidget* group : m_groups) {
        const auto controls = group->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly);
        group->setVisible(std::ranges::any_of(
            controls, [](const QWidget* control) { return !control->isHidden(); }));
    }
}

void BrushForm::finish()
{
    m_layout->addStretch(1);
    refresh();
}

void BrushForm::beginSection(const QString& title, const QString& key)
{
    auto* header = new QToolButton(this);
    header->setObjectName(key);
    header->setText(title);
    header->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    header->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    header->setStyleSheet(QStringLiteral("QToolButton { border: none; font-weight: 600; "
                                         "padding: 3px 0px 1px 0px; background: transparent; }"));
    m_layout->addWidget(header);
    const QString stored = QStringLiteral("brushForm/%1/%2").arg(static_cast<int>(m_kind)).arg(key);
    const int index = static_cast<int>(m_sections.size());
    m_sections.push_back({header, stored, true});
    fold(index, QSettings().value(stored, true).toBool());
    connect(header, &QToolButton::clicked, this, [this, index] {
        const Section& section = m_sections[static_cast<std::size_t>(index)];
        QSettings().setValue(section.key, !section.isOpen);
        fold(index, !section.isOpen);
        refreshVisibility();
    });
}

void BrushForm::fold(int section, bool isOpen)
{
    Section& folded = m_sections[static_cast<std::size_t>(section)];
    folded.isOpen = isOpen;
    folded.header->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
}

void BrushForm::beginRow()
{
    auto* group = new QWidget(this);
    m_row = new QHBoxLayout(group);
    m_row->setContentsMargins(0, 0, 0, 0);
    m_row->setSpacing(8);
    m_layout->addWidget(group);
    m_groups.push_back(group);
}

void BrushForm::addSlider(const QString& label, const ValueSlider::Range& range,
                          std::function<double(const Settings&)> get,
                          std::function<void(Settings&, double)> set, Condition isShown)
{
    auto* slider = new ValueSlider(label, range, this);
    connect(slider, &ValueSlider::valueEdited, this, [this, set](double value) {
        change([&](Settings& settings) { set(settings, value); });
    });
    bind(
        slider, [slider, get](const Settings& s) { slider->setValue(get(s)); }, isShown);
}

void BrushForm::addRange(const QString& label, const ValueSlider::Range& range,
                         std::function<model::ValueRange&(Settings&)> value, Condition isShown)
{
    auto* slider = new RangeSlider(label, range, this);
    connect(slider, &RangeSlider::valueEdited, this,
            [this, value](const model::ValueRange& edited) {
                change([&](Settings& settings) { value(settings) = edited; });
            });
    bind(
        slider, [slider, value](Settings settings) { slider->setValue(value(settings)); }, isShown);
}

void BrushForm::addChoice(const QString& label, const QStringList& names,
                          std::function<int(const Settings&)> get,
                          std::function<void(Settings&, int)> set, Condition isShown)
{
    auto* box = new QComboBox(this);
    box->addItems(names);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(box, &QComboBox::activated, this,
            [this, set](int index) { change([&](Settings& settings) { set(settings, index); }); });
    bind(
        labelled(label, box, this), [box, get](const Settings& s) { box->setCurrentIndex(get(s)); },
        isShown);
}

void BrushForm::addCheck(const QString& label, const QString& tip,
                         std::function<bool(const Settings&)> get,
                         std::function<void(Settings&, bool)> set, Condition isShown)
{
    auto* box = new QCheckBox(label, this);
    box->setToolTip(tip);
    connect(box, &QCheckBox::clicked, this,
            [this, set](bool on) { change([&](Settings& settings) { set(settings, on); }); });
    bind(
        box, [box, get](const Settings& s) { box->setChecked(get(s)); }, isShown);
}

void BrushForm::addColour(const QString& label,
                          std::function<model::PaintColor(const Settings&)> get,
                          std::function<void(Settings&, const model::PaintColor&)> set)
{
    auto* button = new QToolButton(this);
    button->setAccessibleName(label);
    connect(button, &QToolButton::clicked, this, [this, label, get, set] {
        const model::PaintColor now = get(m_state.brush(m_kind));
        const QColor chosen = QColorDialog::getColor(QColor(now[0], now[1], now[2]), this, label,
                                                     QColorDialog::DontUseNativeDialog);
        if (chosen.isValid()) {
            change([&](Settings& settings) {
                set(settings, {static_cast<std::uint8_t>(chosen.red()),
                               static_cast<std::uint8_t>(chosen.green()),
                               static_cast<std::uint8_t>(chosen.blue())});
            });
        }
    });
    bind(labelled(label, button, this),
         [button, get](const Settings& s) {
             const model::PaintColor now = get(s);
             QPixmap swatch(32, 14);
             swatch.fill(QColor(now[0], now[1], now[2]));
             button->setIconSize(swatch.size());
             button->setIcon(swatch);
         },
         {});
}

void BrushForm::addSwatch(std::function<QColor(const Settings&)> color,
                          std::function<QString(const Settings&)> text)
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* swatch = new QLabel(row);
    swatch->setObjectName(QStringLiteral("swatch"));
    auto* name = new QLabel(row);
    name->setObjectName(QStringLiteral("swatchText"));
    name->setWordWrap(true);
    layout->addWidget(swatch);
    layout->addWidget(name, 1);
    bind(row,
         [swatch, name, color, text](const Settings& s) {
             QPixmap filled(14, 14);
             filled.fill(color(s));
             swatch->setPixmap(filled);
             name->setText(text(s));
         },
         {});
}

void BrushForm::addText(const QString& label, std::function<QString(const Settings&)> get,
                        std::function<void(Settings&, const QString&)> set)
{
    auto* line = new QLineEdit(this);
    connect(line, &QLineEdit::editingFinished, this, [this, line, set] {
        change([&](Settings& settings) { set(settings, line->text()); });
    });
    bind(labelled(label, line, this),
         [line, get](const Settings& s) {
             if (!line->hasFocus()) {
                 line->setText(get(s));
             }
         },
         {});
}

void BrushForm::addNumberLists(const std::vector<NumberList>& lists, const Condition& isShown)
{
    beginRow();
    for (const NumberList& list : lists) {
        auto* line = new QLineEdit(this);
        line->setMinimumWidth(40);
        line->setPlaceholderText(tr("all"));
        line->setToolTip(list.tip);
        const auto numbers = list.numbers;
        connect(line, &QLineEdit::editingFinished, this, [this, line, numbers] {
            change([&](Settings& settings) { numbers(settings) = numberListOf(line->text()); });
        });
        bind(
            labelled(list.label, line, this),
            [line, numbers](Settings settings) {
                if (!line->hasFocus()) {
                    line->setText(numberListText(numbers(settings)));
                }
            },
            isShown);
    }
    endRow();
}

void BrushForm::addCurve(std::function<model::DistributionCurve(const Settings&)> get,
                         std::function<void(Settings&, const model::DistributionCurve&)> set,
                         Condition isShown)
{
    auto* curve = new CurveEditor(this);
    curve->setToolTip(tr("How often low (left) to high values (right) come: draw it; a double "
                         "click makes all equal"));
    connect(curve, &CurveEditor::edited, this, [this, curve, set] {
        change([&](Settings& settings) { set(settings, curve->curve()); });
    });
    bind(
        labelled(tr("Frequency"), curve, this),
        [curve, get](const Settings& s) { curve->setCurve(get(s)); }, isShown);
}

void BrushForm::addClips(std::function<std::vector<model::ClipWeight>&(Settings&)> clips,
                         ClipsOnOffer offer)
{
    auto* mix = new ClipMix(clipNamesOf(m_state.scene(), offer), this);
    connect(mix, &ClipMix::edited, this, [this, clips](const model::ClipWeight& edited) {
        change([&](Settings& settings) {
            auto& all = clips(settings);
            const auto known = std::ranges::find(all, edited.clip, &model::ClipWeight::clip);
            if (edited.weight <= 0.0F) {
                std::erase_if(all, [&](const auto& clip) { return clip.clip == edited.clip; });
            } else if (known != all.end()) {
                known->weight = edited.weight;
            } else {
                all.push_back(edited);
            }
        });
    });
    bind(mix, [mix, clips](Settings settings) { mix->setClips(clips(settings)); }, {});
}

void BrushForm::addButton(const QString& label, const QString& tip, std::function<void()> run,
                          Condition isShown)
{
    auto* button = new QPushButton(label, this);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, std::move(run));
    bind(
        button, [](const Settings&) {}, isShown);
}

void BrushForm::addText(const QString& label, std::function<std::string(const Settings&)> get,
                        std::function<void(Settings&, const std::string&)> set)
{
    auto* line = new QLineEdit(this);
    line->setObjectName(QStringLiteral("brushText"));
    connect(line, &QLineEdit::textEdited, this, [this, set](const QString& text) {
        change([&](Settings& settings) { set(settings, text.toStdString()); });
    });
    bind(labelled(label, line, this),
         [line, get](const Settings& s) {
             if (!line->hasFocus()) {
                 line->setText(QString::fromStdString(get(s)));
             }
         },
         {});
}

void BrushForm::addLabel(const QString& text, Condition isShown)
{
    bind(
        new QLabel(text, this), [](const Settings&) {}, std::move(isShown));
}

void BrushForm::addNote(const QString& text, Condition isShown)
{
    auto* note = new QLabel(text, this);
    note->setWordWrap(true);
    note->setEnabled(false);
    bind(
        note, [](const Settings&) {}, isShown);
}

} // namespace crowd::widgets
