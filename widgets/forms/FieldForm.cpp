// SPDX-License-Identifier: MIT
#include "widgets/forms/FieldForm.h"

#include <algorithm>

#include <QtCore/QMetaMethod>
#include <QtCore/QSettings>
#include <QtCore/QTimer>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QToolButton>

#include "widgets/forms/FieldControls.h"
#include "widgets/forms/FormRows.h"
#include "widgets/state/BrushTexts.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

FieldForm::FieldForm(FormTarget target, QString key, EditorState* state, QWidget* parent)
    : QWidget(parent), m_target(std::move(target)), m_key(std::move(key)), m_state(state),
      m_layout(new QVBoxLayout(this))
{
    m_layout->setSpacing(4);
    m_layout->setContentsMargins(6, 4, 6, 6);
}

const void* FieldForm::object(const Bound& bound) const
{
    void* root = const_cast<void*>(m_target.read()); // paths lead through what is only read
    return bound.path ? bound.path(root) : root;
}

model::FieldValue FieldForm::value(const Bound& bound) const
{
    return bound.field->get(object(bound));
}

void FieldForm::change(const Bound& bound, const std::function<void(void*)>& apply)
{
    if (m_isRefreshing) {
        return;
    }
    m_target.edit([&](void* root) { apply(bound.path ? bound.path(root) : root); });
}

void FieldForm::setValue(const Bound& bound, model::FieldValue value)
{
    change(bound, [&](void* object) { bound.field->set(object, value); });
    if (!m_isRefreshing && !(this->value(bound) == value)) {
        QTimer::singleShot(0, this, &FieldForm::refresh); // refused: the control says what it is
    }
}

void FieldForm::addFields(std::span<const model::FieldInfo> fields, const FieldPath& path,
                          const Condition& isShown)
{
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const model::FieldMeta& meta = fields[i].meta;
        if (*meta.section != '\0') {
            beginSection(fieldText(meta.section), QString::fromUtf8(meta.section).toLower());
        }
        const bool beginsRow =
            !meta.isBeside && i + 1 < fields.size() && fields[i + 1].meta.isBeside;
        if (beginsRow) {
            beginRow();
        } else if (!meta.isBeside) {
            endRow();
        }
        addField(fields[i], path, isShown);
    }
    endRow();
}

void FieldForm::addField(const model::FieldInfo& field, const FieldPath& path,
                         const Condition& isShown)
{
    Bound bound{&field, path, isShown};
    if (field.isShown) {
        bound.isShown = [this, isShown, inner = Bound{&field, path, {}}] {
            return (!isShown || isShown()) && inner.field->isShown(object(inner), context());
        };
    }
    if (field.isList()) {
        addList(bound);
    } else if (field.isGroup()) {
        addGroup(bound);
    } else if (*field.meta.label != '\0') {
        addControl(*this, bound);
    }
}

void FieldForm::addGroup(const Bound& bound)
{
    const auto inside = bound.field->childOf;
    const FieldPath path = bound.path;
    addFields(
        bound.field->children,
        [inside, path](void* root) { return inside(path ? path(root) : root); }, bound.isShown);
}

/// The items one below the other, and a button for one more.
void FieldForm::addList(const Bound& bound)
{
    if (*bound.field->meta.label == '\0') {
        return;
    }
    const std::size_t items = bound.field->count(object(bound));
    m_lists.push_back({bound, items});
    ++m_inside;
    for (std::size_t i = 0; i < items; ++i) {
        addItem(bound, i);
    }
    --m_inside;
    auto* button = new QToolButton(this);
    button->setObjectName(QStringLiteral("add-%1").arg(QLatin1String(bound.field->meta.key)));
    button->setText(fieldText(bound.field->meta.label));
    button->setIcon(iconNamed("add"));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setAutoRaise(true);
    connect(button, &QToolButton::clicked, this, [this, bound] {
        change(bound,
               [&](void* object) { bound.field->resize(object, bound.field->count(object) + 1); });
    });
    bind(
        button, [] {}, bound.isShown);
}

void FieldForm::addItem(const Bound& list, std::size_t index)
{
    const model::FieldInfo& field = *list.field;
    const FieldPath path = [list, index](void* root) {
        return list.field->itemOf(list.path ? list.path(root) : root, index);
    };
    for (std::size_t i = 0; i < field.children.size(); ++i) {
        if (i == 0) {
            beginRow();
        }
        addField(field.children[i], path, list.isShown);
        if (i == 0) {
            addRemoval(list, index, list.isShown);
            endRow();
        }
    }
}

void FieldForm::addRemoval(const Bound& list, std::size_t index, const Condition& isShown)
{
    auto* button = new QToolButton(this);
    button->setObjectName(
        QStringLiteral("remove-%1-%2").arg(QLatin1String(list.field->meta.key)).arg(index));
    button->setIcon(iconNamed("remove"));
    button->setToolTip(tr("Take it out of the list"));
    button->setAutoRaise(true);
    connect(button, &QToolButton::clicked, this, [this, list, index] {
        change(list, [&](void* object) { list.field->erase(object, index); });
    });
    bind(
        button, [] {}, isShown);
}

bool FieldForm::isOutdated() const
{
    return std::ranges::any_of(m_lists, [this](const List& list) {
        return list.bound.field->count(object(list.bound)) != list.items;
    });
}

void FieldForm::bind(QWidget* row, std::function<void()> refresh, Condition isShown)
{
    if (m_row != nullptr) {
        m_row->addWidget(row, 1);
    } else {
        m_layout->addWidget(row);
    }
    m_rows.push_back(
        {row, std::move(refresh), std::move(isShown), static_cast<int>(m_sections.size()) - 1});
}

void FieldForm::addLabelled(const QString& label, QWidget* control, std::function<void()> refresh,
                            Condition isShown)
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* text = new QLabel(label, row);
    text->setBuddy(control);
    layout->addWidget(text);
    layout->addWidget(control, 1);
    bind(row, std::move(refresh), std::move(isShown));
}

void FieldForm::addSlider(const QString& label, const ValueSlider::Range& range,
                          std::function<double()> get, std::function<void(double)> set,
                          Condition isShown)
{
    auto* slider = new ValueSlider(label, range, this);
    connect(slider, &ValueSlider::valueEdited, this, std::move(set));
    connect(slider, &ValueSlider::held, this, &FieldForm::held);
    bind(
        slider, [slider, get = std::move(get)] { slider->setValue(get()); }, std::move(isShown));
}

void FieldForm::addChoice(const QString& label, const QStringList& names, std::function<int()> get,
                          std::function<void(int)> set, Condition isShown, const QStringList& tips)
{
    auto* box = new QComboBox(this);
    box->addItems(names);
    for (int i = 0; i < box->count() && i < tips.size(); ++i) {
        box->setItemData(i, tips[i], Qt::ToolTipRole);
    }
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(box, &QComboBox::activated, this, std::move(set));
    addLabelled(
        label, box, [box, get = std::move(get)] { box->setCurrentIndex(get()); },
        std::move(isShown));
}

void FieldForm::refresh()
{
    if (isOutdated()) {
        return;
    }
    m_isRefreshing = true;
    for (const Row& row : m_rows) {
        row.refresh();
    }
    refreshVisibility();
    m_isRefreshing = false;
}

void FieldForm::refreshVisibility()
{
    std::vector<bool> isUsed(m_sections.size(), false);
    for (const Row& row : m_rows) {
        const bool matters = !row.isShown || row.isShown();
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

std::vector<FieldForm::Setting> FieldForm::settings() const
{
    std::vector<Setting> all;
    for (const Row& row : m_rows) {
        const QString name = nameOfRow(*row.widget);
        if (name.isEmpty() || (row.isShown && !row.isShown())) {
            continue;
        }
        const QString section =
            row.section >= 0 ? m_sections[static_cast<std::size_t>(row.section)].header->text()
                             : QString();
        const auto isSame = [&](const Setting& other) {
            return other.name == name && other.section == section;
        };
        if (std::ranges::none_of(all, isSame)) { // one of many items stands for all
            all.push_back({name, section, tipOfRow(*row.widget), row.widget});
        }
    }
    return all;
}

bool FieldForm::isHeldTogether() const
{
    return isSignalConnected(QMetaMethod::fromSignal(&FieldForm::held));
}

void FieldForm::reveal(QWidget& row)
{
    for (const Row& known : m_rows) {
        if (known.widget == &row && known.section >= 0 &&
            !m_sections[static_cast<std::size_t>(known.section)].isOpen) {
            foldByHand(known.section, true);
        }
    }
    QTimer::singleShot(0, &row, [&row] { // where it is, is known afterwards
        scrollTo(row);
        flashRow(row);
        if (QWidget* control = controlOfRow(row)) {
            control->setFocus(Qt::ShortcutFocusReason);
        }
    });
}

void FieldForm::finish()
{
    m_layout->addStretch(1);
    refresh();
}

void FieldForm::beginSection(const QString& title, const QString& key)
{
    auto* header = new QToolButton(this);
    header->setObjectName(key);
    header->setText(title);
    header->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    header->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    header->setStyleSheet(QStringLiteral("QToolButton { border: none; font-weight: 600; "
                                         "padding: 3px 0px 1px 0px; background: transparent; }"));
    endRow();
    m_layout->addWidget(header);
    const QString stored = m_key + QLatin1Char('/') + key;
    const int index = static_cast<int>(m_sections.size());
    m_sections.push_back({header, stored, true});
    fold(index, QSettings().value(stored, true).toBool());
    connect(header, &QToolButton::clicked, this, [this, index] {
        foldByHand(index, !m_sections[static_cast<std::size_t>(index)].isOpen);
    });
}

void FieldForm::foldByHand(int section, bool isOpen)
{
    QSettings().setValue(m_sections[static_cast<std::size_t>(section)].key, isOpen);
    fold(section, isOpen);
    refreshVisibility();
}

void FieldForm::fold(int section, bool isOpen)
{
    Section& folded = m_sections[static_cast<std::size_t>(section)];
    folded.isOpen = isOpen;
    folded.header->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
}

void FieldForm::beginRow()
{
    auto* group = new QWidget(this);
    m_row = new QHBoxLayout(group);
    m_row->setContentsMargins(0, 0, 0, 0);
    m_row->setSpacing(8);
    m_layout->addWidget(group);
    m_groups.push_back(group);
}

void FieldForm::addNote(const QString& text, const Condition& isShown)
{
    if (m_inside > 0 || !m_areNotesShown) {
        return; // it would come again with every item
    }
    auto* note = new QLabel(text, this);
    note->setWordWrap(true);
    note->setEnabled(false);
    bind(
        note, [] {}, isShown);
}

} // namespace crowd::widgets
