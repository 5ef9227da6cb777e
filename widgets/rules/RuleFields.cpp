// SPDX-License-Identifier: MIT
#include "widgets/rules/RuleFields.h"

#include <algorithm>

#include <QtCore/QCoreApplication>
#include <QtGui/QMouseEvent>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QColorDialog>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>

#include "model/population/Columns.h"
#include "widgets/forms/NumberBox.h"
#include "widgets/forms/WrapRow.h"
#include "widgets/rules/RuleTexts.h"
#include "widgets/state/FeatureTexts.h"
#include "widgets/state/RelationTexts.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kWidestClips = 150; ///< a narrow panel has room for so much, logical pixels

struct RuleFieldsText
{
    Q_DECLARE_TR_FUNCTIONS(Rules)
};

/// A combo box over entries with ids.
template<class Entry>
void addEntryField(QHBoxLayout* row, const std::vector<Entry>& entries, std::uint32_t id,
                   const QString& any, const std::function<void(std::uint32_t)>& changed)
{
    QStringList names;
    std::vector<std::uint32_t> ids;
    if (id == model::kNotChosen) {
        names << RuleFieldsText::tr("choose…");
        ids.push_back(id);
    }
    if (!any.isEmpty() || id == 0 || (entries.empty() && ids.empty())) {
        names << (any.isEmpty() ? RuleFieldsText::tr("choose…") : any);
        ids.push_back(0);
    }
    for (const Entry& entry : entries) {
        names << QString::fromStdString(entry.name);
        ids.push_back(entry.id);
    }
    auto found = std::ranges::find(ids, id);
    if (found == ids.end()) {
        names << RuleFieldsText::tr("(gone)");
        ids.push_back(id);
        found = ids.end() - 1;
    }
    addChoiceField(row, names, static_cast<int>(found - ids.begin()),
                   [ids, changed](int index) { changed(ids[static_cast<std::size_t>(index)]); });
}

/// What is chosen and what can be, where the panel is narrower than the words.
void showWhole(QComboBox& box)
{
    constexpr int kListMargin = 28; ///< with a scroll bar
    box.setToolTip(box.currentText());
    box.view()->setMinimumWidth(box.view()->sizeHintForColumn(0) + kListMargin);
}

} // namespace

void addChoiceField(QHBoxLayout* row, const QStringList& names, int index,
                    const std::function<void(int)>& changed)
{
    auto* box = new QComboBox;
    box->addItems(names);
    box->setCurrentIndex(index);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(2);
    box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    showWhole(*box);
    row->addWidget(box, 1);
    if (changed) {
        QObject::connect(box, &QComboBox::activated, box, changed);
    }
}

void addGroupedField(QHBoxLayout* row, const QStringList& names,
                     const std::vector<std::vector<int>>& groups, int index,
                     const std::function<void(int)>& changed)
{
    addChoiceField(row, {}, -1, {});
    auto* box = qobject_cast<QComboBox*>(row->itemAt(row->count() - 1)->widget());
    for (const std::vector<int>& group : groups) {
        if (box->count() > 0) {
            box->insertSeparator(box->count());
        }
        for (const int each : group) {
            box->addItem(names[each], each);
        }
    }
    box->setCurrentIndex(box->findData(index));
    box->setMaxVisibleItems(box->count());
    showWhole(*box);
    QObject::connect(box, &QComboBox::activated, box,
                     [box, changed](int at) { changed(box->itemData(at).toInt()); });
}

void addNumberField(QHBoxLayout* row, double value, double low, double high, const QString& suffix,
                    const std::function<void(double)>& changed, const QString& zero)
{
    auto* box = new NumberBox;
    box->setSpecialValueText(zero);
    box->setRange(low, high);
    box->setDecimals(2);
    box->setSingleStep(high <= 1.0 ? 0.05 : 0.5);
    box->setSuffix(suffix);
    box->setValue(value);
    box->setKeyboardTracking(false);
    box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    box->setMinimumWidth(44);
    row->addWidget(box, 1);
    QObject::connect(box, &QDoubleSpinBox::valueChanged, box, changed);
}

void addCountField(QHBoxLayout* row, std::uint32_t value, std::uint32_t most, const QString& suffix,
                   const std::function<void(std::uint32_t)>& changed, const QString& zero)
{
    addNumberField(
        row, value, 0.0, most, suffix,
        [changed](double count) { changed(static_cast<std::uint32_t>(count)); }, zero);
    auto* box = qobject_cast<QDoubleSpinBox*>(row->itemAt(row->count() - 1)->widget());
    box->setDecimals(0);
    box->setSingleStep(1.0);
}

void addTextField(QHBoxLayout* row, const QString& text, const QString& placeholder,
                  const std::function<void(const QString&)>& changed)
{
    auto* line = new QLineEdit(text);
    line->setPlaceholderText(placeholder);
    line->setMinimumWidth(40);
    row->addWidget(line, 1);
    QObject::connect(line, &QLineEdit::editingFinished, line, [line, text, changed] {
        if (line->text() != text) {
            changed(line->text());
        }
    });
}

void addReferenceField(QHBoxLayout* row, const model::Scene& scene, model::FieldRole role,
                       std::uint32_t id, const QString& any,
                       const std::function<void(std::uint32_t)>& changed)
{
    switch (role) {
    case model::FieldRole::Place:
        addEntryField(row, scene.places, id, any, changed);
        break;
    case model::FieldRole::Path:
        addEntryField(row, scene.paths, id, any, changed);
        break;
    case model::FieldRole::State:
        addEntryField(row, scene.states, id, any, changed);
        break;
    case model::FieldRole::Light:
        addEntryField(row, scene.lights, id, any, changed);
        break;
    case model::FieldRole::Feature:
        addEntryField(row, featureEntries(scene), id, any, changed);
        break;
    case model::FieldRole::Relation:
        addEntryField(row, relationEntries(scene), id, any, changed);
        break;
    case model::FieldRole::Template:
        addEntryField(row, scene.templates, id, any, changed);
        break;
    default:
        addEntryField(row, scene.numbers, id, any, changed);
        break;
    }
}

namespace {

/// Those that somebody has, as bits.
std::uint64_t tagsOfPeople(const model::Scene& scene)
{
    std::uint64_t all = 0;
    for (const std::uint64_t each : scene.population.column(model::columns::tags)) {
        all |= each;
    }
    return all;
}

/// Those that have a name, in its order, then those that somebody has, and that one.
std::vector<std::uint8_t> tagsToChoose(const model::Scene& scene, std::uint8_t chosen)
{
    std::vector<std::uint8_t> tags;
    for (const model::TagName& each : scene.tags) {
        tags.push_back(static_cast<std::uint8_t>(each.bit));
    }
    const std::uint64_t borne = tagsOfPeople(scene) | std::uint64_t{1} << chosen;
    for (std::uint8_t bit = 0; bit < model::kTagCount; ++bit) {
        const bool isListed = std::ranges::find(tags, bit) != tags.end();
        if (!isListed && (borne >> bit & 1U) != 0) {
            tags.push_back(bit);
        }
    }
    return tags;
}

/// kTagCount: none.
std::uint8_t freeTag(const std::vector<std::uint8_t>& tags)
{
    std::uint8_t bit = 0;
    while (bit < model::kTagCount && std::ranges::find(tags, bit) != tags.end()) {
        ++bit;
    }
    return bit;
}

} // namespace

void addTagField(QHBoxLayout* row, const model::Scene& scene, std::uint8_t tag,
                 const std::function<void(std::uint8_t)>& changed)
{
    const std::vector<std::uint8_t> tags = tagsToChoose(scene, tag);
    QStringList names;
    for (const std::uint8_t each : tags) {
        names << RuleFieldsText::tr("tag %1").arg(tagText(scene, each));
    }
    const std::uint8_t free = freeTag(tags);
    if (free < model::kTagCount) {
        names << RuleFieldsText::tr("a new tag, %1").arg(tagText(scene, free));
    }
    const auto chosen = std::ranges::find(tags, tag);
    addChoiceField(row, names, static_cast<int>(chosen - tags.begin()),
                   [changed, tags, free](int index) {
                       const auto at = static_cast<std::size_t>(index);
                       changed(at < tags.size() ? tags[at] : free);
                   });
}

namespace {

/// Ticks one entry after the other by mouse; a click beside it, or Escape, closes it.
class TickFilter : public QObject
{
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        auto* menu = static_cast<QMenu*>(watched);
        if (event->type() != QEvent::MouseButtonRelease) {
            return false;
        }
        QAction* action = menu->actionAt(static_cast<QMouseEvent*>(event)->position().toPoint());
        if (action == nullptr || !action->isCheckable() || menu->activeAction() != action) {
            return false;
        }
        action->toggle();
        return true;
    }
};

void keepOpenOnTicks(QMenu& menu)
{
    menu.installEventFilter(new TickFilter(&menu));
}

/// Those that were ticked before come first, with their weights.
std::vector<model::ClipWeight> tickedClips(const QMenu& menu,
                                           const std::vector<model::ClipWeight>& before)
{
    std::vector<model::ClipWeight> all = before;
    for (const QAction* action : menu.actions()) {
        const std::string name = action->data().toString().toStdString();
        const bool isIn = std::ranges::find(all, name, &model::ClipWeight::clip) != all.end();
        if (action->isChecked() && !isIn) {
            all.push_back({name, 1.0F});
        } else if (!action->isChecked()) {
            std::erase_if(all, [&](const auto& clip) { return clip.clip == name; });
        }
    }
    return all;
}

} // namespace

void addClipField(QHBoxLayout* row, const model::Scene& scene,
                  const std::vector<model::ClipWeight>& clips,
                  const std::function<void(const std::vector<model::ClipWeight>&)>& changed)
{
    auto* button = new QToolButton;
    QStringList chosen;
    auto* menu = new QMenu(button);
    std::vector<std::string> known;
    for (const model::TemplateEntry& entry : scene.templates) {
        for (const std::string& name : entry.clipNames) {
            if (std::ranges::find(known, name) == known.end()) {
                known.push_back(name);
            }
        }
    }
    for (const model::ClipWeight& clip : clips) {
        chosen << QString::fromStdString(clip.clip);
        if (std::ranges::find(known, clip.clip) == known.end()) {
            known.push_back(clip.clip);
        }
    }
    for (const std::string& name : known) {
        QAction* action = menu->addAction(QString::fromStdString(name));
        action->setData(QString::fromStdString(name));
        action->setCheckable(true);
        action->setChecked(std::ranges::find(clips, name, &model::ClipWeight::clip) != clips.end());
    }
    keepOpenOnTicks(*menu);
    QObject::connect(menu, &QMenu::aboutToHide, button, [menu, clips, changed] {
        if (const auto all = tickedClips(*menu, clips); all != clips) {
            // The fields are made anew by it, and this menu is one of them.
            QMetaObject::invokeMethod(
                menu, [changed, all] { changed(all); }, Qt::QueuedConnection);
        }
    });
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
    const QString text = chosen.isEmpty() ? RuleFieldsText::tr("choose clips…")
                                          : chosen.join(RuleFieldsText::tr(" or "));
    button->setText(button->fontMetrics().elidedText(text, Qt::ElideRight, kWidestClips));
    button->setToolTip(text);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    row->addWidget(button, 1);
}

void addClipWeights(QVBoxLayout* layout, const std::vector<model::ClipWeight>& clips,
                    const std::function<void(const std::vector<model::ClipWeight>&)>& changed)
{
    for (std::size_t i = 0; clips.size() > 1 && i < clips.size(); ++i) {
        auto* row = new WrapRow;
        row->setSpacing(4);
        row->addSpacing(40);
        layout->addLayout(row);
        auto* name = new QLabel(QString::fromStdString(clips[i].clip));
        name->setToolTip(name->text());
        name->setMinimumWidth(20);
        name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        row->addWidget(name, 1);
        addNumberField(row, static_cast<double>(clips[i].weight), 0.0, 1000.0,
                       RuleFieldsText::tr(" ×"), [clips, i, changed](double weight) {
                           std::vector<model::ClipWeight> all = clips;
                           all[i].weight = static_cast<float>(weight);
                           changed(all);
                       });
        row->itemAt(row->count() - 1)
            ->widget()
            ->setToolTip(RuleFieldsText::tr("How often it comes, against the others"));
    }
}

namespace {

/// A combo box over names, each once; the one that is chosen is there even where nobody has it.
void addNameField(QHBoxLayout* row, std::vector<std::string> names, const std::string& chosen,
                  const QString& none, const std::function<void(const std::string&)>& changed)
{
    if (!chosen.empty() && std::ranges::find(names, chosen) == names.end()) {
        names.push_back(chosen);
    }
    names.insert(names.begin(), std::string());
    QStringList texts;
    for (const std::string& name : names) {
        texts << (name.empty() ? none : QString::fromStdString(name));
    }
    const auto index = std::ranges::find(names, chosen) - names.begin();
    addChoiceField(row, texts, static_cast<int>(index), [names, changed](int choice) {
        changed(names[static_cast<std::size_t>(choice)]);
    });
}

void addOnce(std::vector<std::string>& names, const std::string& name)
{
    if (std::ranges::find(names, name) == names.end()) {
        names.push_back(name);
    }
}

} // namespace

void addOneClipField(QHBoxLayout* row, const model::Scene& scene, const std::string& clip,
                     const std::function<void(const std::string&)>& changed)
{
    std::vector<std::string> names;
    for (const model::TemplateEntry& entry : scene.templates) {
        for (const std::string& name : entry.clipNames) {
            addOnce(names, name);
        }
    }
    addNameField(row, std::move(names), clip, RuleFieldsText::tr("choose…"), changed);
}

void addSlotField(QHBoxLayout* row, const model::Scene& scene, const std::string& slot,
                  const std::function<void(const std::string&)>& changed)
{
    std::vector<std::string> names;
    for (const model::TemplateEntry& entry : scene.templates) {
        for (std::size_t i = 0; entry.asset && i < entry.asset->slots.size(); ++i) {
            if (entry.asset->slots[i].tintable) {
                addOnce(names, entry.asset->slots[i].name);
            }
        }
    }
    addNameField(row, std::move(names), slot, RuleFieldsText::tr("all that can be"), changed);
}

void addColorField(QHBoxLayout* row, const model::PaintColor& color, const QString& tip,
                   const std::function<void(const model::PaintColor&)>& changed)
{
    const QColor shown(color[0], color[1], color[2]);
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("ruleColor"));
    QPixmap pixmap(28, 14);
    pixmap.fill(shown);
    button->setIcon(pixmap);
    button->setIconSize(pixmap.size());
    button->setToolTip(tip);
    row->addWidget(button);
    QObject::connect(button, &QToolButton::clicked, button, [button, shown, changed] {
        const QColor chosen = QColorDialog::getColor(shown, button);
        if (chosen.isValid()) {
            changed({static_cast<std::uint8_t>(chosen.red()),
                     static_cast<std::uint8_t>(chosen.green()),
                     static_cast<std::uint8_t>(chosen.blue())});
        }
    });
}

void addRemoveButton(QHBoxLayout* row, const QString& tip, const std::function<void()>& pressed)
{
    auto* button = new QToolButton;
    button->setIcon(iconNamed("remove"));
    button->setAutoRaise(true);
    button->setFixedWidth(kSmallButton);
    button->setToolTip(tip);
    row->addWidget(button);
    QObject::connect(button, &QToolButton::clicked, button, pressed);
}

} // namespace crowd::widgets
