// SPDX-License-Identifier: MIT
#include "widgets/docks/BrushForm.h"

#include <algorithm>
#include <set>

#include <QtCore/QRegularExpression>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>

#include "widgets/docks/CurveEditor.h"

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

QString listText(const std::vector<int>& numbers)
{
    QStringList texts;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::size_t last = i;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) {
            ++last;
        }
        texts << (last > i + 1 ? QStringLiteral("%1-%2").arg(numbers[i] + 1).arg(numbers[last] + 1)
                               : QString::number(numbers[i] + 1));
        i = last > i + 1 ? last : i;
    }
    return texts.join(QStringLiteral(", "));
}

/// People count from 1, the model from 0.
std::vector<int> listOf(const QString& text)
{
    static const QRegularExpression kPiece(QStringLiteral("(\\d{1,4})(?:\\s*-\\s*(\\d{1,4}))?"));
    std::set<int> numbers;
    auto pieces = kPiece.globalMatch(text);
    while (pieces.hasNext()) {
        const auto piece = pieces.next();
        const int low = piece.captured(1).toInt();
        const int high = piece.captured(2).isEmpty() ? low : piece.captured(2).toInt();
        for (int number = std::max(low, 1); number <= high; ++number) {
            numbers.insert(number - 1);
        }
    }
    return {numbers.begin(), numbers.end()};
}

} // namespace

BrushForm::BrushForm(EditorState& state, model::BrushKind kind, QWidget* parent)
    : QWidget(parent), m_state(state), m_kind(kind), m_layout(new QVBoxLayout(this))
{
    m_layout->setSpacing(4);
    m_layout->setContentsMargins(6, 6, 6, 6);
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
    m_layout->addWidget(row);
    m_refreshers.push_back([row, refresh, isShown](const Settings& settings) {
        refresh(settings);
        row->setVisible(!isShown || isShown(settings));
    });
}

void BrushForm::refresh()
{
    m_isRefreshing = true;
    for (const auto& refresher : m_refreshers) {
        refresher(m_state.brush(m_kind));
    }
    m_isRefreshing = false;
}

void BrushForm::finish()
{
    m_layout->addStretch(1);
    refresh();
}

void BrushForm::addTitle(const QString& text)
{
    auto* title = new QLabel(text, this);
    QFont font = title->font();
    font.setBold(true);
    title->setFont(font);
    title->setContentsMargins(0, 6, 0, 0);
    m_layout->addWidget(title);
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

void BrushForm::addNumberList(const QString& label, const QString& tip,
                              std::function<std::vector<int>(const Settings&)> get,
                              std::function<void(Settings&, std::vector<int>)> set,
                              Condition isShown)
{
    auto* line = new QLineEdit(this);
    line->setPlaceholderText(tr("all"));
    line->setToolTip(tip);
    connect(line, &QLineEdit::editingFinished, this, [this, line, set] {
        change([&](Settings& settings) { set(settings, listOf(line->text())); });
    });
    bind(
        labelled(label, line, this),
        [line, get](const Settings& s) {
            if (!line->hasFocus()) {
                line->setText(listText(get(s)));
            }
        },
        isShown);
}

void BrushForm::addCurve(std::function<model::DistributionCurve(const Settings&)> get,
                         std::function<void(Settings&, const model::DistributionCurve&)> set,
                         Condition isShown)
{
    auto* curve = new CurveEditor(this);
    curve->setToolTip(tr("How often low (left) to high values (right) come: draw it"));
    connect(curve, &CurveEditor::edited, this, [this, curve, set] {
        change([&](Settings& settings) { set(settings, curve->curve()); });
    });
    bind(
        curve, [curve, get](const Settings& s) { curve->setCurve(get(s)); }, isShown);
}

void BrushForm::addClips(std::function<std::vector<model::ClipWeight>(const Settings&)> get,
                         std::function<void(Settings&, std::vector<model::ClipWeight>)> set)
{
    std::vector<std::string> names;
    for (const model::TemplateEntry& entry : m_state.scene().templates) {
        for (const std::string& name : entry.clipNames) {
            if (std::ranges::find(names, name) == names.end()) {
                names.push_back(name);
            }
        }
    }
    auto* area = new QWidget(this);
    auto* grid = new QGridLayout(area);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(2);
    std::vector<QCheckBox*> boxes;
    for (std::size_t i = 0; i < names.size(); ++i) {
        auto* box = new QCheckBox(QString::fromStdString(names[i]), area);
        const std::string name = names[i];
        connect(box, &QCheckBox::clicked, this, [this, get, set, name](bool on) {
            change([&](Settings& settings) {
                auto clips = get(settings);
                std::erase_if(clips, [&](const auto& clip) { return clip.clip == name; });
                if (on) {
                    clips.push_back({name, 1.0F});
                }
                set(settings, clips);
            });
        });
        boxes.push_back(box);
        grid->addWidget(box, static_cast<int>(i) / 2, static_cast<int>(i) % 2);
    }
    bind(area,
         [boxes, names, get](const Settings& s) {
             const auto clips = get(s);
             for (std::size_t i = 0; i < boxes.size(); ++i) {
                 boxes[i]->setChecked(
                     std::ranges::find(clips, names[i], &model::ClipWeight::clip) != clips.end());
             }
         },
         {});
}

} // namespace crowd::widgets
