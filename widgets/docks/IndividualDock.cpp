// SPDX-License-Identifier: MIT
#include "widgets/docks/IndividualDock.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QCoreApplication>
#include <QtCore/QEvent>
#include <QtGui/QPainter>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QColorDialog>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/population/PropertyValues.h"
#include "widgets/docks/FeatureRows.h"
#include "widgets/forms/NumberList.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kRefreshMs = 60;
constexpr int kSwatch = 18;
constexpr double kWholeTurn = 360.0; ///< degrees
constexpr int kShortWord = 3;        ///< letters of a box that may be narrow
constexpr int kLongestSlot = 80;     ///< names in files can be of any length, logical pixels
constexpr int kLongestName = 140;    ///< of a part or a template
constexpr double kMostSeats = 16777216.0;

/// The colour in a frame; a stroke through the frame says that there is no tint, or no common one.
QIcon tintIcon(std::optional<model::Tint> tint, const QColor& line)
{
    const bool isTinted = tint && tint->strength > 0;
    QPixmap picture(kSwatch, kSwatch);
    picture.fill(isTinted ? QColor(tint->red, tint->green, tint->blue) : QColor(Qt::transparent));
    QPainter painter(&picture);
    painter.setPen(line);
    painter.drawRect(0, 0, kSwatch - 1, kSwatch - 1);
    if (!isTinted) {
        painter.drawLine(0, kSwatch - 1, kSwatch - 1, 0);
    }
    return picture;
}

/// A name that leaves the fields beside it their room.
QString shortened(const QString& name, const QWidget& widget, int room)
{
    return widget.fontMetrics().elidedText(name, Qt::ElideMiddle, room);
}

QComboBox* narrowBox(QWidget* parent)
{
    auto* box = new QComboBox(parent);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setPlaceholderText(IndividualDock::tr("mixed"));
    return box;
}

QString described(const char* text)
{
    return QCoreApplication::translate("Fields", text);
}

QString labelOf(const model::PropertyInfo& property)
{
    const QString label = described(property.meta.label);
    const auto unit = QString::fromUtf8(property.meta.unit);
    return unit.isEmpty() ? label : label + QLatin1Char(' ') + unit;
}

/// One that a row can show as it is, and that has a name to show.
bool isPlainNumber(const model::PropertyInfo& property)
{
    const model::PropertyKind kind = property.traits.kind;
    return (kind == model::PropertyKind::Number || kind == model::PropertyKind::Angle) &&
           model::isScalar(property.column.type) && *property.meta.label != '\0';
}

NumberField* newNumberField(const model::PropertyInfo& property, QWidget* parent)
{
    const model::FieldMeta& meta = property.meta;
    const bool hasOwnRange = meta.sliderLow < meta.sliderHigh;
    return new NumberField(hasOwnRange ? meta.sliderLow : meta.low * meta.shownScale,
                           hasOwnRange ? meta.sliderHigh : meta.high * meta.shownScale,
                           meta.decimals, parent);
}

void fill(QComboBox& box, const std::vector<std::string>& names)
{
    box.clear();
    for (const std::string& name : names) {
        box.addItem(QString::fromStdString(name));
    }
}

} // namespace

IndividualDock::IndividualDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Character"), "individual", parent), m_state(state), m_write(state),
      m_title(new QLabel(this)), m_content(new QWidget(this)), m_template(narrowBox(this)),
      m_clip(narrowBox(this)), m_tags(new QLineEdit(this)),
      m_seat(new NumberField(1.0, kMostSeats, 0, this)), m_seatPlace(new QLabel(this)),
      m_standUp(new QToolButton(this)), m_features(new FeatureRows(state, this)),
      m_slotArea(new QWidget(this))
{
    auto* all = new QWidget(this);
    auto* layout = new QVBoxLayout(all);
    layout->setContentsMargins(6, 4, 6, 6);
    m_title->setWordWrap(true);
    layout->addWidget(m_title);
    layout->addWidget(m_content);
    layout->addStretch(1);
    auto* form = new QFormLayout(m_content);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(3);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    buildForm(form);
    form->addRow(m_features);
    form->addRow(m_slotArea);
    setScrolledContent(all);
    connectState();
    refresh();
}

void IndividualDock::connectState()
{
    m_refresh.setSingleShot(true);
    m_refresh.setInterval(kRefreshMs);
    connect(&m_refresh, &QTimer::timeout, this, &IndividualDock::refresh);
    const auto later = [this] {
        if (!m_refresh.isActive()) {
            m_refresh.start();
        }
    };
    connect(&m_state.selection(), &Selection::changed, this, later);
    connect(&m_state.document(), &model::SceneDocument::changed, this, later);
    connect(&m_state.document(), &model::SceneDocument::editRefused, this, later);
    connect(m_template, &QComboBox::activated, this, [this](int index) {
        m_write.setTemplate(static_cast<model::TemplateId>(m_template->itemData(index).toUInt()));
    });
    connect(m_clip, &QComboBox::textActivated, this,
            [this](const QString& name) { m_write.setClip(name); });
    connect(m_seat, &NumberField::valueEdited, this, [this](double number) {
        m_write.setSeat(number);
        m_refresh.start(); // what was refused goes out of the field
    });
    connect(m_standUp, &QToolButton::clicked, this, [this] { m_write.standUp(); });
    connect(m_tags, &QLineEdit::editingFinished, this, [this] {
        if (m_tags->isModified()) {
            m_tags->setModified(false);
            m_write.setTags(m_tags->text());
        }
    });
}

void IndividualDock::changeEvent(QEvent* event)
{
    DockBase::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        m_standUp->setIcon(iconNamed("person"));
        m_refresh.start(); // frames of the tints
    }
}

void IndividualDock::buildForm(QFormLayout* form)
{
    for (const model::PropertyInfo& property : model::properties()) {
        if (property.isWrittenBy(model::kWrittenByPanel)) {
            addProperty(form, property);
        }
    }
    m_tags->setToolTip(tr("Names or numbers of tags from 1 to 64, as brave, 3-5"));
    form->addRow(labelOf(model::propertyInfo(model::ColumnId::Tags)), m_tags);
}

void IndividualDock::addProperty(QFormLayout* form, const model::PropertyInfo& property)
{
    switch (property.id) {
    case model::ColumnId::Template:
        form->addRow(labelOf(property), m_template);
        return;
    case model::ColumnId::Position:
        addPosition(form, property);
        return;
    case model::ColumnId::Clip:
        form->addRow(labelOf(property), m_clip);
        return;
    case model::ColumnId::Seat:
        addSeat(form, property);
        return;
    default: // colours, materials and parts follow with the slots
        if (isPlainNumber(property)) {
            addNumber(form, property);
        }
    }
}

void IndividualDock::addPosition(QFormLayout* form, const model::PropertyInfo& property)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(3);
    for (int axis = 0; axis < 3; ++axis) {
        NumberField* field = newNumberField(property, m_content);
        field->setToolTip(tr("Metres along %1").arg(QLatin1Char("XYZ"[axis])));
        m_position[static_cast<std::size_t>(axis)] = field;
        row->addWidget(field);
        connect(field, &NumberField::valueEdited, this,
                [this, axis](double value) { m_write.setPosition(axis, value); });
    }
    form->addRow(labelOf(property), row);
}

void IndividualDock::addNumber(QFormLayout* form, const model::PropertyInfo& property)
{
    NumberField* field = newNumberField(property, m_content);
    field->setToolTip(described(property.meta.tip));
    field->setZeroText(described(property.meta.zero));
    form->addRow(labelOf(property), field);
    m_numbers.push_back({field, &property});
    connect(field, &NumberField::valueEdited, this,
            [this, &property](double shown) { m_write.setNumber(property, shown); });
}

void IndividualDock::addSeat(QFormLayout* form, const model::PropertyInfo& property)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(3);
    m_seat->setToolTip(tr("Number of the seat"));
    m_seat->setAccessibleName(labelOf(property));
    m_standUp->setAccessibleName(tr("Stand Up"));
    m_seat->setMaximumWidth(64);
    m_standUp->setAutoRaise(true);
    m_standUp->setIcon(iconNamed("person"));
    m_standUp->setToolTip(tr("Stand up: the seat is free again"));
    row->addWidget(m_seat);
    row->addWidget(m_standUp);
    row->addStretch(1);
    form->addRow(labelOf(property), row);
    m_seatPlace->setWordWrap(true); // a panel as narrow as the others
    form->addRow(QString(), m_seatPlace);
}

void IndividualDock::refresh()
{
    const SelectedPeople selected = people();
    m_content->setVisible(!selected.rows().empty());
    refreshTitle(selected);
    if (!selected.rows().empty()) {
        rebuild(selected);
        refreshNumbers(selected);
        refreshSeat(selected);
        m_features->refresh(selected);
        refreshSlots(selected);
        refreshParts(selected);
    }
}

void IndividualDock::refreshTitle(const SelectedPeople& selected)
{
    if (selected.rows().empty()) {
        m_title->setText(tr("Nobody is selected. Press V and click somebody."));
        return;
    }
    const model::TemplateEntry* entry = selected.groups().front().entry;
    const QString name =
        entry == nullptr ? QString()
                         : shortened(QString::fromStdString(entry->name), *m_title, kLongestName);
    m_title->setText(
        selected.rows().size() == 1
            ? tr("<b>%1</b>, number %2").arg(name.toHtmlEscaped()).arg(selected.ids().front())
            : tr("<b>%n characters</b>", nullptr, static_cast<int>(selected.rows().size())));
}

void IndividualDock::refreshNumbers(const SelectedPeople& selected)
{
    const model::Population& all = m_state.scene().population;
    m_template->clear();
    for (const model::TemplateEntry& entry : m_state.scene().templates) {
        m_template->addItem(QString::fromStdString(entry.name), entry.id);
    }
    const auto id = selected.common<model::TemplateId>(
        [&](std::size_t row) { return all.column(model::columns::templateId)[row]; });
    m_template->setCurrentIndex(id ? m_template->findData(*id) : -1);
    const auto positions = all.column(model::columns::position);
    for (int axis = 0; axis < 3; ++axis) {
        m_position[static_cast<std::size_t>(axis)]->setValue(selected.common<double>(
            [&](std::size_t row) { return static_cast<double>(positions[row][axis]); }));
    }
    for (const NumberRow& item : m_numbers) {
        const model::PropertyInfo& property = *item.property;
        const std::span<const std::byte> column = all.columnBytes(property.id);
        item.field->setValue(selected.common<double>([&](std::size_t row) {
            const double shown =
                model::scalarAt(property.column.type, column, row) * property.meta.shownScale;
            // Whoever has turned twice looks the same way as before.
            return property.traits.kind == model::PropertyKind::Angle
                       ? std::remainder(shown, kWholeTurn)
                       : shown;
        }));
    }
    const auto tags = selected.common<std::uint64_t>(
        [&](std::size_t row) { return all.column(model::columns::tags)[row]; });
    if (!m_tags->hasFocus() || !m_tags->isModified()) {
        m_tags->setText(tags ? tagListText(m_state.scene().tags, *tags) : QString());
        m_tags->setPlaceholderText(tags ? tr("none") : tr("mixed"));
    }
}

void IndividualDock::refreshSeat(const SelectedPeople& selected)
{
    const auto column = m_state.scene().population.column(model::columns::seat);
    const auto seated = std::ranges::count_if(
        selected.rows(), [&](std::size_t row) { return column[row] != model::kNoSeat; });
    const bool isOne = selected.rows().size() == 1;
    m_seat->setEnabled(isOne);
    m_standUp->setEnabled(seated > 0);
    m_seat->setPlaceholderText(seated > 0 ? tr("mixed") : tr("none"));
    m_seat->setValue(std::nullopt);
    m_seatPlace->setVisible(seated > 0);
    if (!isOne || seated == 0) {
        m_seatPlace->setText(tr("%n seated", nullptr, static_cast<int>(seated)));
        return;
    }
    m_seatPlace->clear();
    const model::SeatId id = column[selected.rows().front()];
    m_seat->setValue(static_cast<double>(id & 0xFFFFFFU) + 1.0);
    const model::StageEntry* stage =
        m_state.scene().findStage(static_cast<std::uint8_t>(id >> 24U));
    if (stage != nullptr && stage->asset && (id & 0xFFFFFFU) < stage->asset->seats.size()) {
        const model::Seat& seat = stage->asset->seats[id & 0xFFFFFFU];
        m_seatPlace->setText(tr("row %1, wedge %2").arg(seat.rank + 1).arg(seat.wedge + 1));
    }
}

void IndividualDock::rebuild(const SelectedPeople& selected)
{
    std::vector<std::weak_ptr<const model::Template>> wanted;
    for (const SelectedPeople::Group& group : selected.groups()) {
        wanted.emplace_back(group.entry == nullptr ? nullptr : group.entry->asset);
    }
    const auto isSame = [](const auto& a, const auto& b) {
        return !a.owner_before(b) && !b.owner_before(a);
    };
    if (std::ranges::equal(wanted, m_builtFor, isSame)) {
        return;
    }
    m_builtFor = std::move(wanted);
    m_slots.clear();
    m_parts.clear();
    delete m_slotArea->layout();
    qDeleteAll(m_slotArea->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
    fill(*m_clip, selected.clips());
    auto* form = new QFormLayout(m_slotArea);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(3);
    for (const std::string& slot : selected.slotNames()) {
        addSlot(form, selected, slot);
    }
    for (const std::string& part : selected.parts()) {
        addPart(form, part, m_parts.empty());
    }
}

void IndividualDock::addSlot(QFormLayout* form, const SelectedPeople& selected,
                             const std::string& slot)
{
    SlotRow row{slot, new QToolButton(m_slotArea), narrowBox(m_slotArea), narrowBox(m_slotArea)};
    row.color->setToolTip(tr("Tint; a click chooses a colour, a right click takes it off"));
    row.color->setAccessibleName(QString::fromStdString(slot));
    row.color->setEnabled(selected.isTintable(slot));
    row.color->setContextMenuPolicy(Qt::CustomContextMenu);
    row.mode->setObjectName(QStringLiteral("tintMode"));
    row.mode->addItems({tr("Multiply"), tr("Replace")});
    row.mode->setAccessibleName(tr("Mode of the tint of %1").arg(QString::fromStdString(slot)));
    row.mode->setToolTip(tr("Whether the tint multiplies the colour that is there or replaces it"));
    row.mode->setMinimumContentsLength(kShortWord);
    row.mode->setEnabled(selected.isTintable(slot));
    const std::vector<std::string> choices = selected.choices(slot);
    fill(*row.choice, choices);
    row.choice->setVisible(choices.size() > 1);
    auto* tint = new QHBoxLayout;
    tint->addWidget(row.color);
    tint->addWidget(row.mode, 1);
    const QString name = QString::fromStdString(slot);
    auto* label = new QLabel(shortened(name, *m_slotArea, kLongestSlot), m_slotArea);
    label->setToolTip(name);
    form->addRow(label, tint);
    form->addRow(row.choice); // over both columns: materials have long names
    connect(row.color, &QToolButton::clicked, this, [this, slot] { chooseTint(slot); });
    connect(row.color, &QToolButton::customContextMenuRequested, this,
            [this, slot] { m_write.setTint(slot, {}); });
    connect(row.mode, &QComboBox::activated, this,
            [this, slot](int index) { m_write.setTintMode(slot, index == 1); });
    connect(row.choice, &QComboBox::textActivated, this,
            [this, slot](const QString& choice) { m_write.setChoice(slot, choice); });
    m_slots.push_back(row);
}

void IndividualDock::addPart(QFormLayout* form, const std::string& part, bool isFirst)
{
    const QString name = QString::fromStdString(part);
    auto* box = new QCheckBox(shortened(name, *m_slotArea, kLongestName), m_slotArea);
    box->setToolTip(name);
    form->addRow(isFirst ? tr("Parts") : QString(), box);
    connect(box, &QCheckBox::clicked, this, [this, part](bool on) { m_write.setPart(part, on); });
    m_parts.push_back({part, box});
}

void IndividualDock::refreshSlots(const SelectedPeople& selected)
{
    using Alike = SelectedPeople::Group;
    const model::Population& all = m_state.scene().population;
    // By name: the same index means another clip in another template.
    const auto clips = all.column(model::columns::clip);
    const auto templates = all.column(model::columns::templateId);
    const auto clip = selected.common<std::string_view>([&](std::size_t row) -> std::string_view {
        const model::TemplateEntry* entry = m_state.scene().findTemplate(templates[row]);
        const bool isKnown = entry != nullptr && clips[row] < entry->clipNames.size();
        return isKnown ? std::string_view(entry->clipNames[clips[row]]) : std::string_view();
    });
    m_clip->setCurrentIndex(
        clip ? m_clip->findText(QString::fromUtf8(clip->data(), std::ssize(*clip))) : -1);
    for (const SlotRow& item : m_slots) {
        const auto slotOf = [&](const Alike& group) { return group.slotIndex(item.slot); };
        item.color->setIcon(tintIcon(
            selected.commonOf<model::Tint>(slotOf,
                                           [&](std::size_t row, int slot) {
                                               return all.column(model::columns::tint(slot))[row];
                                           }),
            palette().color(QPalette::Mid)));
        const auto replacing = all.column(model::columns::tintReplaces);
        const auto isReplacing = selected.commonOf<bool>(slotOf, [&](std::size_t row, int slot) {
            return (replacing[row] >> static_cast<unsigned>(slot) & 1U) != 0;
        });
        item.mode->setCurrentIndex(isReplacing ? static_cast<int>(*isReplacing) : -1);
        const auto choices = all.column(model::columns::materialChoices);
        const auto choice = selected.commonOf<std::string_view>(
            slotOf, [&](std::size_t row, int slot) -> std::string_view {
                const auto& entry = *m_state.scene().findTemplate(templates[row]);
                const auto& names = entry.asset->slots[static_cast<std::size_t>(slot)].choices;
                const std::size_t index = choices[row][static_cast<std::size_t>(slot)];
                return names[index < names.size() ? index : 0].name;
            });
        item.choice->setCurrentIndex(
            choice ? item.choice->findText(QString::fromUtf8(choice->data(), std::ssize(*choice)))
                   : -1);
    }
}

void IndividualDock::refreshParts(const SelectedPeople& selected)
{
    const auto parts = m_state.scene().population.column(model::columns::parts);
    for (const PartRow& item : m_parts) {
        const auto shown = selected.commonOf<bool>(
            [&](const SelectedPeople::Group& group) { return group.partIndex(item.part); },
            [&](std::size_t row, int part) {
                return (parts[row] >> static_cast<unsigned>(part) & 1U) != 0;
            });
        item.box->setCheckState(!shown   ? Qt::PartiallyChecked
                                : *shown ? Qt::Checked
                                         : Qt::Unchecked);
    }
}

void IndividualDock::chooseTint(const std::string& slot)
{
    QColor before(Qt::white);
    const SelectedPeople selected = people();
    const model::Population& all = m_state.scene().population;
    const auto tint = selected.commonOf<model::Tint>(
        [&](const SelectedPeople::Group& group) { return group.slotIndex(slot); },
        [&](std::size_t row, int index) { return all.column(model::columns::tint(index))[row]; });
    if (tint && tint->strength > 0) {
        before = QColor(tint->red, tint->green, tint->blue);
    }
    const QColor color =
        QColorDialog::getColor(before, this, tr("Tint of %1").arg(QString::fromStdString(slot)),
                               QColorDialog::DontUseNativeDialog);
    if (color.isValid()) {
        m_write.setTint(slot, {static_cast<std::uint8_t>(color.red()),
                               static_cast<std::uint8_t>(color.green()),
                               static_cast<std::uint8_t>(color.blue()), 255});
    }
}

} // namespace crowd::widgets
