// SPDX-License-Identifier: MIT
#include "widgets/docks/IndividualDock.h"

#include <map>
#include <string_view>

#include <QtGui/QPainter>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QColorDialog>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/document/SceneEdit.h"

namespace crowd::widgets {

namespace {

constexpr int kRefreshMs = 60;
constexpr double kDegrees = 180.0 / 3.14159265358979;
constexpr int kSwatch = 18;

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

/// The value that all rows share, if they do.
template<class T, class Get>
std::optional<T> common(std::span<const std::size_t> rows, const Get& get)
{
    std::optional<T> shared;
    for (const std::size_t row : rows) {
        const T value = get(row);
        if (shared && !(*shared == value)) {
            return std::nullopt;
        }
        shared = value;
    }
    return shared;
}

std::vector<std::size_t> rowsOf(const EditorState& state)
{
    std::vector<std::size_t> rows;
    for (const model::IndividualId id : state.selection().ids()) {
        const std::size_t row = state.scene().population.rowOf(id);
        if (row != model::Population::npos) {
            rows.push_back(row);
        }
    }
    return rows;
}

} // namespace

IndividualDock::IndividualDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Individual"), "individual", parent), m_state(state), m_title(new QLabel(this)),
      m_content(new QWidget(this)), m_clip(new QComboBox(this)),
      m_group(new NumberField(0.0, 4294967295.0, 0, this)), m_seat(new QLabel(this)),
      m_slotArea(new QWidget(this))
{
    auto* all = new QWidget(this);
    auto* layout = new QVBoxLayout(all);
    m_title->setWordWrap(true);
    layout->addWidget(m_title);
    layout->addWidget(m_content);
    layout->addStretch(1);
    auto* form = new QFormLayout(m_content);
    form->setContentsMargins(0, 0, 0, 0);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    buildNumbers(form);
    form->addRow(m_slotArea);
    setScrolledContent(all);

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
    connect(m_clip, &QComboBox::textActivated, this, &IndividualDock::setClip);
    refresh();
}

void IndividualDock::buildNumbers(QFormLayout* form)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(3);
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = new NumberField(-1e5, 1e5, 2, m_content);
        field->setToolTip(tr("Metres along %1").arg(QLatin1Char("XYZ"[axis])));
        m_position[static_cast<std::size_t>(axis)] = field;
        row->addWidget(field);
        connect(field, &NumberField::valueEdited, this,
                [this, axis](double value) { setPosition(axis, value); });
    }
    form->addRow(tr("Position"), row);
    addFloat(form, tr("Heading °"), model::columns::heading, -36000.0, 36000.0, 1, kDegrees);
    addFloat(form, tr("Height"), model::columns::height, 0.1, 10.0, 3, 1.0);
    addFloat(form, tr("Girth"), model::columns::girth, 0.1, 10.0, 3, 1.0);
    form->addRow(tr("Clip"), m_clip);
    addFloat(form, tr("Phase"), model::columns::phase, 0.0, 1.0, 3, 1.0);
    addFloat(form, tr("Speed"), model::columns::playbackSpeed, 0.0, 20.0, 2, 1.0);
    form->addRow(tr("Group"), m_group);
    form->addRow(tr("Seat"), m_seat);
    connect(m_group, &NumberField::valueEdited, this, &IndividualDock::setGroup);
}

void IndividualDock::addFloat(QFormLayout* form, const QString& label,
                              model::ColumnKey<float> column, double low, double high, int decimals,
                              double scale)
{
    auto* field = new NumberField(low, high, decimals, m_content);
    form->addRow(label, field);
    m_floats.push_back({field, column, scale});
    connect(field, &NumberField::valueEdited, this, [this, column, scale](double value) {
        setFloat(column, static_cast<float>(value / scale));
    });
}

const model::TemplateEntry* IndividualDock::entryOf(model::IndividualId id) const
{
    const model::Population& people = m_state.scene().population;
    const std::size_t row = people.rowOf(id);
    return m_state.scene().findTemplate(people.column(model::columns::templateId)[row]);
}

const model::TemplateEntry* IndividualDock::firstEntry() const
{
    return m_state.selection().isEmpty() ? nullptr : entryOf(m_state.selection().ids().front());
}

void IndividualDock::refresh()
{
    m_isFilling = true;
    const std::vector<std::size_t> rows = rowsOf(m_state);
    m_content->setVisible(!rows.empty());
    if (rows.empty()) {
        m_title->setText(tr("Nobody is selected. Press V and click somebody."));
        m_isFilling = false;
        return;
    }
    const model::Population& people = m_state.scene().population;
    const model::TemplateEntry* entry = firstEntry();
    const QString name = entry == nullptr ? QString() : QString::fromStdString(entry->name);
    m_title->setText(rows.size() == 1
                         ? tr("<b>%1</b>, number %2").arg(name).arg(people.ids()[rows.front()])
                         : tr("<b>%n people</b>", nullptr, static_cast<int>(rows.size())));
    for (int axis = 0; axis < 3; ++axis) {
        const auto positions = people.column(model::columns::position);
        m_position[static_cast<std::size_t>(axis)]->setValue(common<double>(
            rows, [&](std::size_t row) { return static_cast<double>(positions[row][axis]); }));
    }
    for (const FloatRow& item : m_floats) {
        const auto values = people.column(item.column);
        item.field->setValue(common<double>(
            rows, [&](std::size_t row) { return static_cast<double>(values[row]) * item.scale; }));
    }
    const auto groups = people.column(model::columns::group);
    m_group->setValue(
        common<double>(rows, [&](std::size_t row) { return static_cast<double>(groups[row]); }));
    const auto seats = people.column(model::columns::seat);
    const auto seat = common<model::SeatId>(rows, [&](std::size_t row) { return seats[row]; });
    m_seat->setText(!seat                     ? tr("mixed")
                    : *seat == model::kNoSeat ? tr("none")
                                              : QString::number(*seat & 0xFFFFFFU));
    rebuildSlots();
    refreshSlots();
    m_isFilling = false;
}

void IndividualDock::rebuildSlots()
{
    const model::TemplateEntry* entry = firstEntry();
    const model::TemplatePtr asset = entry == nullptr ? nullptr : entry->asset;
    if (asset == m_slotsOf && asset) {
        return;
    }
    m_slotsOf = asset;
    m_slots.clear();
    m_parts.clear();
    delete m_slotArea->layout();
    qDeleteAll(m_slotArea->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
    m_clip->clear();
    if (!asset) {
        return;
    }
    for (const std::string& clip : entry->clipNames) {
        m_clip->addItem(QString::fromStdString(clip));
    }
    auto* form = new QFormLayout(m_slotArea);
    form->setContentsMargins(0, 0, 0, 0);
    const auto tintable = std::min<std::size_t>(asset->slots.size(), model::kMaxTintSlots);
    for (std::size_t i = 0; i < tintable; ++i) {
        const model::Slot& slot = asset->slots[i];
        SlotRow row{QString::fromStdString(slot.name), new QToolButton(m_slotArea),
                    new QComboBox(m_slotArea)};
        row.color->setToolTip(tr("Tint; choose a colour"));
        row.color->setEnabled(slot.tintable);
        for (const model::MaterialChoice& choice : slot.choices) {
            row.choice->addItem(QString::fromStdString(choice.name));
        }
        row.choice->setEnabled(slot.choices.size() > 1);
        row.choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        auto* line = new QHBoxLayout;
        line->addWidget(row.color);
        line->addWidget(row.choice, 1);
        form->addRow(row.slot, line);
        const QString name = row.slot;
        connect(row.color, &QToolButton::clicked, this, [this, name] { setTint(name); });
        connect(row.choice, &QComboBox::activated, this,
                [this, name](int choice) { setChoice(name, choice); });
        m_slots.push_back(row);
    }
    for (std::size_t i = 0; i < asset->parts.size(); ++i) {
        auto* box = new QCheckBox(QString::fromStdString(asset->parts[i].name), m_slotArea);
        form->addRow(i == 0 ? tr("Parts") : QString(), box);
        connect(box, &QCheckBox::clicked, this,
                [this, i](bool isShown) { setPart(static_cast<int>(i), isShown); });
        m_parts.push_back(box);
    }
}

void IndividualDock::refreshSlots()
{
    const std::vector<std::size_t> rows = rowsOf(m_state);
    const model::Population& people = m_state.scene().population;
    const auto clips = people.column(model::columns::clip);
    const auto templates = people.column(model::columns::templateId);
    // By name: the same index means another clip in another template.
    const auto clip = common<std::string_view>(rows, [&](std::size_t row) -> std::string_view {
        const model::TemplateEntry* entry = m_state.scene().findTemplate(templates[row]);
        const bool isKnown = entry != nullptr && clips[row] < entry->clipNames.size();
        return isKnown ? std::string_view(entry->clipNames[clips[row]]) : std::string_view();
    });
    m_clip->setCurrentIndex(
        clip ? m_clip->findText(QString::fromUtf8(clip->data(), std::ssize(*clip))) : -1);
    m_clip->setPlaceholderText(tr("mixed"));
    for (std::size_t i = 0; i < m_slots.size(); ++i) {
        const auto tints = people.column(model::columns::tint(static_cast<int>(i)));
        m_slots[i].color->setIcon(
            tintIcon(common<model::Tint>(rows, [&](std::size_t row) { return tints[row]; }),
                     palette().color(QPalette::Mid)));
        const auto choices = people.column(model::columns::materialChoices);
        const auto choice =
            common<int>(rows, [&](std::size_t row) { return static_cast<int>(choices[row][i]); });
        m_slots[i].choice->setCurrentIndex(choice.value_or(-1));
    }
    const auto parts = people.column(model::columns::parts);
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
        const auto shown =
            common<bool>(rows, [&](std::size_t row) { return ((parts[row] >> i) & 1U) != 0; });
        m_parts[i]->setCheckState(!shown   ? Qt::PartiallyChecked
                                  : *shown ? Qt::Checked
                                           : Qt::Unchecked);
    }
}

template<class T>
void IndividualDock::write(model::ColumnKey<T> column, const std::vector<T>& values,
                           const QString& undoText)
{
    if (m_isFilling || m_state.document().isEditOpen() || values.empty()) {
        return;
    }
    const std::vector<model::IndividualId> ids(m_state.selection().ids().begin(),
                                               m_state.selection().ids().end());
    const auto edit = m_state.document().beginEdit();
    edit->setColumn(column, ids, std::span<const T>(values));
    edit->commit(undoText);
}

void IndividualDock::setPosition(int axis, double value)
{
    std::vector<glm::vec3> positions;
    for (const std::size_t row : rowsOf(m_state)) {
        positions.push_back(m_state.scene().population.column(model::columns::position)[row]);
        positions.back()[axis] = static_cast<float>(value);
    }
    write(model::columns::position, positions, tr("Move"));
}

void IndividualDock::setFloat(model::ColumnKey<float> column, float value)
{
    write(column, std::vector<float>(m_state.selection().size(), value), tr("Change Individual"));
}

void IndividualDock::setClip(const QString& name)
{
    std::vector<std::uint16_t> clips;
    for (const std::size_t row : rowsOf(m_state)) {
        const auto id = m_state.scene().population.ids()[row];
        const model::TemplateEntry* entry = entryOf(id);
        const int index =
            entry != nullptr && entry->asset ? entry->asset->clipIndex(name.toStdString()) : -1;
        // Who lacks the clip keeps his own.
        clips.push_back(index < 0 ? m_state.scene().population.column(model::columns::clip)[row]
                                  : static_cast<std::uint16_t>(index));
    }
    write(model::columns::clip, clips, tr("Change Clip"));
}

void IndividualDock::setTint(const QString& slot)
{
    const QColor color = QColorDialog::getColor(Qt::white, this, tr("Tint of %1").arg(slot),
                                                QColorDialog::DontUseNativeDialog);
    if (!color.isValid() || m_state.document().isEditOpen()) {
        return;
    }
    const model::Tint tint{static_cast<std::uint8_t>(color.red()),
                           static_cast<std::uint8_t>(color.green()),
                           static_cast<std::uint8_t>(color.blue()), 255};
    std::map<int, std::vector<model::IndividualId>> byColumn;
    for (const model::IndividualId id : m_state.selection().ids()) {
        const model::TemplateEntry* entry = entryOf(id);
        const int index =
            entry != nullptr && entry->asset ? entry->asset->slotIndex(slot.toStdString()) : -1;
        if (index >= 0 && index < model::kMaxTintSlots) {
            byColumn[index].push_back(id);
        }
    }
    const auto edit = m_state.document().beginEdit();
    for (const auto& [index, ids] : byColumn) {
        edit->setColumn(model::columns::tint(index), ids, std::span<const model::Tint>(&tint, 1));
    }
    edit->commit(tr("Change Tint"));
}

void IndividualDock::setChoice(const QString& slot, int choice)
{
    std::vector<model::MaterialChoices> all;
    for (const std::size_t row : rowsOf(m_state)) {
        const auto& people = m_state.scene().population;
        all.push_back(people.column(model::columns::materialChoices)[row]);
        const model::TemplateEntry* entry = entryOf(people.ids()[row]);
        const int index =
            entry != nullptr && entry->asset ? entry->asset->slotIndex(slot.toStdString()) : -1;
        if (index >= 0 && index < model::kMaxTintSlots &&
            static_cast<std::size_t>(choice) <
                entry->asset->slots[static_cast<std::size_t>(index)].choices.size()) {
            all.back()[static_cast<std::size_t>(index)] = static_cast<std::uint8_t>(choice);
        }
    }
    write(model::columns::materialChoices, all, tr("Change Outfit"));
}

void IndividualDock::setPart(int part, bool isShown)
{
    std::vector<std::uint32_t> bits;
    for (const std::size_t row : rowsOf(m_state)) {
        const std::uint32_t old = m_state.scene().population.column(model::columns::parts)[row];
        const std::uint32_t bit = 1U << static_cast<unsigned>(part);
        bits.push_back(isShown ? old | bit : old & ~bit);
    }
    write(model::columns::parts, bits, isShown ? tr("Show Part") : tr("Hide Part"));
}

void IndividualDock::setGroup(double group)
{
    write(model::columns::group,
          std::vector<std::uint32_t>(m_state.selection().size(), static_cast<std::uint32_t>(group)),
          tr("Change Group"));
}

} // namespace crowd::widgets
