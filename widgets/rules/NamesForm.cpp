// SPDX-License-Identifier: MIT
#include "widgets/rules/NamesForm.h"

#include <algorithm>

#include <QtWidgets/QColorDialog>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/document/SceneEdit.h"
#include "widgets/forms/NumberField.h"
#include "widgets/forms/WrapRow.h"
#include "widgets/rules/RuleFields.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

QHBoxLayout* nameRowIn(QVBoxLayout* layout)
{
    auto* row = new WrapRow;
    row->setSpacing(4);
    layout->addLayout(row);
    return row;
}

QIcon tagIcon(const std::array<std::uint8_t, 3>& color)
{
    QPixmap pixmap(14, 14);
    pixmap.fill(QColor(color[0], color[1], color[2]));
    return pixmap;
}

} // namespace

NamesForm::NamesForm(EditorState& state, QWidget* parent)
    : QWidget(parent), m_state(state), m_fold(new QToolButton(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    m_fold->setObjectName(QStringLiteral("foldNames"));
    m_fold->setText(tr("Tags and numbers"));
    m_fold->setToolTip(tr("Names and colours of tags, and numbers of your own that rules can ask "
                          "for and change"));
    m_fold->setCheckable(true);
    m_fold->setAutoRaise(true);
    m_fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_fold->setArrowType(Qt::RightArrow);
    layout->addWidget(m_fold);
    connect(m_fold, &QToolButton::toggled, this, [this](bool isOpen) {
        m_fold->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
        rebuild();
    });
    m_rebuild.setSingleShot(true);
    m_rebuild.setInterval(0);
    connect(&m_rebuild, &QTimer::timeout, this, &NamesForm::rebuild);
    connect(&state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (isOneOf<model::RulesChanged, model::SceneReplaced>(change)) {
                    m_rebuild.start();
                }
            });
}

void NamesForm::rebuild()
{
    delete m_rows;
    m_rows = nullptr;
    if (!m_fold->isChecked()) {
        return;
    }
    m_rows = new QWidget(this);
    auto* rows = new QVBoxLayout(m_rows);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(3);
    for (const model::TagName& tag : m_state.scene().tags) {
        addTagRow(rows, tag);
    }
    for (const model::NumberName& number : m_state.scene().numbers) {
        addNumberRow(rows, number);
    }
    QHBoxLayout* more = nameRowIn(rows);
    const auto addButton = [&](const char* name, const QString& text, const QString& tip,
                               void (NamesForm::*run)()) {
        auto* button = new QToolButton(m_rows);
        button->setObjectName(QLatin1String(name));
        button->setText(text);
        button->setToolTip(tip);
        button->setAutoRaise(true);
        more->addWidget(button);
        connect(button, &QToolButton::clicked, this, run);
    };
    addButton("addTagName", tr("+ tag"), tr("Give a tag a name and a colour"), &NamesForm::addTag);
    addButton("addNumberName", tr("+ number"),
              tr("A number that everybody has, as patience or hunger: rules ask for it"),
              &NamesForm::addNumber);
    more->addStretch(1);
    layout()->addWidget(m_rows);
}

void NamesForm::addTagRow(QVBoxLayout* layout, const model::TagName& tag)
{
    QHBoxLayout* row = nameRowIn(layout);
    auto* color = new QToolButton(m_rows);
    color->setIcon(tagIcon(tag.color));
    color->setToolTip(tr("Colour of the tag in the picture"));
    row->addWidget(color);
    connect(color, &QToolButton::clicked, this, [this, tag] {
        const QColor chosen =
            QColorDialog::getColor(QColor(tag.color[0], tag.color[1], tag.color[2]), this);
        if (chosen.isValid()) {
            changeTag(tag.bit, [&](model::TagName& each) {
                each.color = {static_cast<std::uint8_t>(chosen.red()),
                              static_cast<std::uint8_t>(chosen.green()),
                              static_cast<std::uint8_t>(chosen.blue())};
            });
        }
    });
    row->addWidget(new QLabel(tr("Tag %1").arg(tag.bit + 1)));
    addTextField(row, QString::fromStdString(tag.name), tr("Name"),
                 [this, bit = tag.bit](const QString& text) {
                     changeTag(bit, [&](model::TagName& each) { each.name = text.toStdString(); });
                 });
    addRemoveButton(row, tr("Forget the name; characters keep the tag"), [this, bit = tag.bit] {
        std::vector<model::TagName> tags = m_state.scene().tags;
        std::erase_if(tags, [bit](const model::TagName& each) { return each.bit == bit; });
        setTags(std::move(tags), tr("Forget a tag’s name"));
    });
}

void NamesForm::addNumberRow(QVBoxLayout* layout, const model::NumberName& number)
{
    QHBoxLayout* row = nameRowIn(layout);
    addTextField(row, QString::fromStdString(number.name), tr("Name"),
                 [this, id = number.id](const QString& text) {
                     changeNumber(id,
                                  [&](model::NumberName& each) { each.name = text.toStdString(); });
                 });
    const auto addValue = [&](float model::NumberName::*member, const QString& tip) {
        auto* field = new NumberField(-static_cast<double>(model::kMaxNumber),
                                      static_cast<double>(model::kMaxNumber), 2, m_rows);
        field->setValue(static_cast<double>(number.*member));
        field->setToolTip(tip);
        row->addWidget(field);
        connect(field, &NumberField::valueEdited, this, [this, id = number.id, member](double v) {
            changeNumber(id, [&](model::NumberName& each) {
                each.*member = static_cast<float>(v);
                if (member == &model::NumberName::low) {
                    each.high = std::max(each.high, each.low);
                } else {
                    each.low = std::min(each.low, each.high);
                }
            });
        });
    };
    row->addWidget(new QLabel(tr("from")));
    addValue(&model::NumberName::low, tr("Nobody begins with less"));
    row->addWidget(new QLabel(tr("to")));
    addValue(&model::NumberName::high, tr("Nobody begins with more"));
    if (!number.values.empty()) {
        auto* kept = new QToolButton(m_rows);
        kept->setObjectName(QStringLiteral("forgetKept"));
        kept->setText(tr("%n kept", nullptr, static_cast<int>(number.values.size())));
        kept->setToolTip(
            tr("So many characters begin with what Keep Pose has kept; press to let all "
               "begin between the two again"));
        row->addWidget(kept);
        connect(kept, &QToolButton::clicked, this, [this, id = number.id] {
            changeNumber(id, [](model::NumberName& each) { each.values.clear(); });
        });
    }
    addRemoveButton(row, tr("Delete the number"), [this, id = number.id] {
        std::vector<model::NumberName> numbers = m_state.scene().numbers;
        std::erase_if(numbers, [id](const model::NumberName& each) { return each.id == id; });
        setNumbers(std::move(numbers), tr("Delete a number"));
    });
}

void NamesForm::setTags(std::vector<model::TagName> tags, const QString& undoText)
{
    m_state.document().edit(undoText,
                            [&](model::SceneEdit& edit) { edit.setTags(std::move(tags)); });
}

void NamesForm::setNumbers(std::vector<model::NumberName> numbers, const QString& undoText)
{
    m_state.document().edit(undoText,
                            [&](model::SceneEdit& edit) { edit.setNumbers(std::move(numbers)); });
}

void NamesForm::changeTag(std::uint8_t bit, const std::function<void(model::TagName&)>& change)
{
    std::vector<model::TagName> tags = m_state.scene().tags;
    const auto found = std::ranges::find(tags, bit, &model::TagName::bit);
    if (found != tags.end()) {
        change(*found);
        setTags(std::move(tags), tr("Change a tag"));
    }
}

void NamesForm::changeNumber(model::NumberId id,
                             const std::function<void(model::NumberName&)>& change)
{
    std::vector<model::NumberName> numbers = m_state.scene().numbers;
    const auto found = std::ranges::find(numbers, id, &model::NumberName::id);
    if (found != numbers.end()) {
        change(*found);
        setNumbers(std::move(numbers), tr("Change a number"));
    }
}

/// The first tag that has no name yet.
void NamesForm::addTag()
{
    std::vector<model::TagName> tags = m_state.scene().tags;
    std::uint8_t bit = 0;
    while (bit < model::kTagCount &&
           std::ranges::find(tags, bit, &model::TagName::bit) != tags.end()) {
        ++bit;
    }
    if (bit == model::kTagCount) {
        m_state.showStatus(tr("All 64 tags have names already."));
        return;
    }
    static constexpr std::array<std::array<std::uint8_t, 3>, 6> kColors{{{220, 80, 70},
                                                                         {70, 140, 220},
                                                                         {90, 180, 90},
                                                                         {220, 170, 50},
                                                                         {160, 90, 200},
                                                                         {80, 190, 190}}};
    model::TagName made;
    made.bit = bit;
    made.name = tr("tag %1").arg(bit + 1).toStdString();
    made.color = kColors[bit % kColors.size()];
    tags.insert(std::ranges::upper_bound(tags, bit, {}, &model::TagName::bit), made);
    setTags(std::move(tags), tr("Name a tag"));
}

void NamesForm::addNumber()
{
    std::vector<model::NumberName> numbers = m_state.scene().numbers;
    if (numbers.size() >= model::kMaxNamed) {
        m_state.showStatus(
            tr("There are %1 numbers already, as many as can be.").arg(model::kMaxNamed));
        return;
    }
    model::NumberName made;
    made.id = numbers.empty() ? 1 : numbers.back().id + 1;
    made.name = tr("number %1").arg(made.id).toStdString();
    numbers.push_back(made);
    setNumbers(std::move(numbers), tr("Add a number"));
}

} // namespace crowd::widgets
