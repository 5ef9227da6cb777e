// SPDX-License-Identifier: MIT
#include "widgets/docks/FeaturesDock.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QInputDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/base/Translated.h"
#include "model/brush/FeatureBrush.h"
#include "model/features/FeatureWriting.h"
#include "model/project/FeatureFile.h"
#include "widgets/commands/FeatureCommands.h"
#include "widgets/docks/FeaturePreview.h"
#include "widgets/forms/FieldForm.h"
#include "widgets/forms/LastFolder.h"
#include "widgets/forms/PanelButton.h"
#include "widgets/state/FeatureTexts.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

const QString kFeatureFolder = QStringLiteral("features/folder");
constexpr int kFeatureRows = 12;  ///< seen at once
constexpr int kRoomBelowRows = 6; ///< logical pixels
constexpr int kFeaturesRebuildMs = 30;
constexpr int kRestMs = 400; ///< of the hand, after which a change comes to the scene
constexpr int kBearersMs = 300;

/// All but the name, which the list lets edit.
std::span<const model::FieldInfo> formFields()
{
    static const std::vector<model::FieldInfo> kShown = [] {
        std::vector<model::FieldInfo> shown;
        for (const model::FieldInfo& field : model::fieldsOf<model::FeatureValue>()) {
            if (std::string_view(field.meta.key) != "name") {
                shown.push_back(field);
            }
        }
        return shown;
    }();
    return kShown;
}

QIcon featureSwatch(const model::PaintColor& color)
{
    return swatchIcon(QColor(color[0], color[1], color[2]));
}

} // namespace

FeaturesDock::FeaturesDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Features"), "features", parent), m_state(state), m_kinds(new QComboBox(this)),
      m_values(new QListWidget(this)), m_preview(new FeaturePreview(state, this)),
      m_isWorn(new QCheckBox(this)), m_note(new QLabel(this)), m_kindMenu(new QMenu(this)),
      m_formPlace(new QVBoxLayout)
{
    m_values->setObjectName(QStringLiteral("features"));
    m_values->setFrameShape(QFrame::NoFrame);
    m_values->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_values->setContextMenuPolicy(Qt::CustomContextMenu);
    m_values->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_note->setObjectName(QStringLiteral("featuresNote"));
    m_note->setWordWrap(true);
    m_note->setEnabled(false);
    m_isWorn->setObjectName(QStringLiteral("featureIsWorn"));
    m_isWorn->setChecked(true);
    m_isWorn->setToolTip(tr("Whoever bears the value becomes what you set here, with it. Else only "
                            "those are who come to bear it from now on."));
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(kindRow());
    layout->addWidget(valueButtons());
    layout->addWidget(m_note);
    layout->addWidget(m_values);
    layout->addWidget(m_preview);
    layout->addWidget(m_isWorn);
    layout->addLayout(m_formPlace);
    layout->addStretch(1);
    setScrolledContent(content);
    connectParts();
    connectList();
    fill();
}

FeaturesDock::~FeaturesDock() = default;

QWidget* FeaturesDock::kindRow()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    m_kinds->setObjectName(QStringLiteral("featureKinds"));
    m_kinds->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_kinds->setMinimumContentsLength(8);
    m_kinds->setAccessibleName(tr("Feature"));
    layout->addWidget(m_kinds, 1);
    QToolButton* more = panelButton(row, "preferences", tr("New features, and files of features"),
                                    "featureKindMenu");
    more->setMenu(m_kindMenu);
    more->setPopupMode(QToolButton::InstantPopup);
    connect(m_kindMenu, &QMenu::aboutToShow, this, &FeaturesDock::fillKindMenu);
    layout->addWidget(more);
    return row;
}

QWidget* FeaturesDock::valueButtons()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    QToolButton* add = panelButton(row, "add", tr("Add a value to the feature"), "addFeature");
    connect(add, &QToolButton::clicked, this, [this] {
        if (const model::FeatureKind* shown = kind()) {
            const model::FeatureId made = addFeature(m_state, shown->id);
            fill();
            edit(made);
        }
    });
    layout->addWidget(add);
    m_valueButtons = new QWidget(row);
    auto* chosenRow = new QHBoxLayout(m_valueButtons);
    chosenRow->setContentsMargins(0, 0, 0, 0);
    const auto addButton = [&](const char* icon, const QString& tip, const char* name, auto act) {
        QToolButton* button = panelButton(m_valueButtons, icon, tip, name);
        connect(button, &QToolButton::clicked, this, [this, act] { act(chosenId()); });
        chosenRow->addWidget(button);
    };
    addButton("copy", tr("Duplicate the chosen value"), "duplicateFeature",
              [this](model::FeatureId id) { duplicate(id); });
    addButton("to-brush", tr("Paint the chosen value"), "paintFeature",
              [this](model::FeatureId id) { paintFeature(m_state, id); });
    addButton("give", tr("Give the chosen value to who is selected, or to all where nobody is"),
              "giveFeature", [this](model::FeatureId id) { giveFeature(m_state, id); });
    addButton("select-all", tr("Select who bears the chosen value"), "selectBearers",
              [this](model::FeatureId id) { selectBearers(m_state, id); });
    chosenRow->addStretch(1);
    addButton("delete", tr("Remove the chosen value"), "removeFeature",
              [this](model::FeatureId id) { removeFeature(m_state, id); });
    layout->addWidget(m_valueButtons, 1);
    return row;
}

/// What is changed next is the copy.
void FeaturesDock::duplicate(model::FeatureId id)
{
    const model::FeatureId made = duplicateFeature(m_state, id);
    if (made != 0) {
        fill();
        edit(made);
    }
}

void FeaturesDock::connectParts()
{
    m_rebuild.setSingleShot(true);
    m_rebuild.setInterval(kFeaturesRebuildMs);
    connect(&m_rebuild, &QTimer::timeout, this, &FeaturesDock::fill);
    m_keep.setSingleShot(true);
    m_keep.setInterval(kRestMs);
    connect(&m_keep, &QTimer::timeout, this, &FeaturesDock::keepChange);
    m_count.setSingleShot(true);
    m_count.setInterval(kBearersMs);
    connect(&m_count, &QTimer::timeout, this, &FeaturesDock::refreshBearers);
    connect(&m_state.document(), &model::SceneDocument::changed, this, &FeaturesDock::follow);
    connect(&m_state.document(), &model::SceneDocument::editRefused, &m_rebuild,
            qOverload<>(&QTimer::start));
    connect(this, &QDockWidget::visibilityChanged, this,
            [this](bool isSeen) { isSeen ? m_count.start() : keepChange(); });
    connect(&m_state, &EditorState::toolChanged, this, &FeaturesDock::followBrush);
    connect(&m_state, &EditorState::brushChanged, this, &FeaturesDock::followBrush);
    connect(m_kinds, &QComboBox::currentIndexChanged, this, [this] {
        if (!m_isFilling) {
            keepChange();
            fillValues();
        }
    });
}

/// What the brush in hand paints.
void FeaturesDock::followBrush()
{
    const model::BrushSettings* brush = m_state.activeBrush();
    const model::FeatureSettings* settings = brush != nullptr ? featureSettings(*brush) : nullptr;
    const model::FeatureKind* kind =
        settings != nullptr ? findKind(m_state.scene().features, settings->kind) : nullptr;
    if (kind == nullptr) {
        return;
    }
    m_kinds->setCurrentIndex(std::max(0, m_kinds->findData(uint{kind->id})));
    const model::FeatureValue* value =
        settings->values.size() == 1 ? kind->find(settings->values.front().clip) : nullptr;
    for (int row = 0; value != nullptr && row < m_values->count(); ++row) {
        if (m_values->item(row)->data(kIdRole).toUInt() == value->id) {
            m_values->setCurrentRow(row);
        }
    }
}

/// A brush in hand that paints one value of the feature paints the one that is chosen now.
void FeaturesDock::leadBrush()
{
    const model::BrushSettings* brush = m_state.activeBrush();
    const model::FeatureSettings* settings = brush != nullptr ? featureSettings(*brush) : nullptr;
    const model::FeatureKind* shown = kind();
    const model::FeatureValue* value = findFeature(m_state.scene().features, chosenId());
    const bool isLed = settings != nullptr && shown != nullptr && value != nullptr &&
                       settings->kind == shown->name && !settings->takesOff &&
                       settings->values.size() == 1;
    if (isLed && settings->values.front().clip != value->name) {
        paintFeature(m_state, value->id);
    }
}

void FeaturesDock::connectList()
{
    connect(m_values, &QListWidget::currentRowChanged, this, [this] {
        if (!m_isFilling) {
            keepChange();
            showValue();
            leadBrush();
        }
    });
    connect(m_values, &QListWidget::customContextMenuRequested, this, &FeaturesDock::showMenu);
    removeByKey(*m_values, [this] {
        keepChange();
        removeFeature(m_state, chosenId());
    });
    connect(m_values, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        if (!m_isFilling) {
            keepChange();
            const auto id = static_cast<model::FeatureId>(item->data(kIdRole).toUInt());
            (void)renameFeature(m_state, id, item->text());
            m_rebuild.start(); // what was refused gets its old name back
        }
    });
}

void FeaturesDock::follow(const model::SceneChange& change)
{
    if (isOneOf<model::FeaturesChanged, model::SceneReplaced>(change)) {
        m_edited.reset();
        m_keep.stop();
    }
    if (isOneOf<model::TemplatesChanged, model::SceneReplaced>(change)) {
        m_isFormOld = true; // it offers names of templates
    }
    if (isOneOf<model::FeaturesChanged, model::TemplatesChanged, model::SceneReplaced>(change)) {
        m_rebuild.start();
    }
    m_count.start();
}

const model::FeatureKind* FeaturesDock::kind() const
{
    return findKind(m_state.scene().features,
                    static_cast<std::uint8_t>(m_kinds->currentData().toUInt()));
}

model::FeatureId FeaturesDock::chosenId() const
{
    const QListWidgetItem* item = m_values->currentItem();
    return item != nullptr ? static_cast<model::FeatureId>(item->data(kIdRole).toUInt())
                           : model::FeatureId{0};
}

const model::FeatureValue* FeaturesDock::chosen() const
{
    return m_edited ? &*m_edited : findFeature(m_state.scene().features, chosenId());
}

void FeaturesDock::fill()
{
    if (m_values->viewport()->findChild<QLineEdit*>() != nullptr) {
        m_rebuild.start(); // not under the hands of who renames
        return;
    }
    QVariant shown = m_kinds->currentData();
    std::vector<uint> fresh;
    for (const model::FeatureKind& each : m_state.scene().features) {
        if (m_kinds->findData(uint{each.id}) < 0) {
            fresh.push_back(each.id);
        }
    }
    if (m_kinds->count() > 0 && fresh.size() == 1) {
        shown = fresh.front(); // added, or back again
    }
    m_isFilling = true;
    m_kinds->clear();
    for (const model::FeatureKind& each : m_state.scene().features) {
        m_kinds->addItem(featureText(each.name), uint{each.id});
    }
    m_kinds->setCurrentIndex(std::max(0, m_kinds->findData(shown)));
    m_isFilling = false;
    fillValues();
}

void FeaturesDock::addRow(const model::FeatureValue& value)
{
    auto* item = new QListWidgetItem(featureSwatch(value.color), featureText(value.name), m_values);
    item->setData(kIdRole, value.id);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    item->setToolTip(tr("Double click or F2: rename"));
}

void FeaturesDock::fillValues()
{
    const model::FeatureId before = chosenId();
    m_isFilling = true;
    m_values->clear();
    const model::FeatureKind* shown = kind();
    for (std::size_t i = 0; shown != nullptr && i < shown->values.size(); ++i) {
        addRow(shown->values[i]);
        if (shown->values[i].id == before) {
            m_values->setCurrentRow(static_cast<int>(i));
        }
    }
    if (m_values->currentRow() < 0 && m_values->count() > 0) {
        m_values->setCurrentRow(0);
    }
    m_isFilling = false;
    const int rows = std::min(m_values->count(), kFeatureRows);
    m_values->setFixedHeight(rows * m_values->sizeHintForRow(0) + kRoomBelowRows);
    m_note->setText(shown == nullptr
                        ? tr("A feature is what people are like: an emotion, an outfit, a team. "
                             "The button above adds one.")
                        : tr("The feature has no values yet: + adds one."));
    m_note->setVisible(m_values->count() == 0);
    m_values->setVisible(m_values->count() > 0);
    showValue();
}

/// The chosen one, below the list.
void FeaturesDock::showValue()
{
    const model::FeatureValue* value = chosen();
    m_valueButtons->setEnabled(value != nullptr);
    m_preview->setVisible(value != nullptr);
    m_isWorn->setVisible(value != nullptr);
    m_preview->setFeature(value);
    if (m_form == nullptr || value == nullptr || m_isFormOld || m_form->isOutdated()) {
        rebuildForm();
    } else {
        m_form->refresh();
    }
    refreshBearers();
}

void FeaturesDock::rebuildForm()
{
    m_isFormOld = false;
    if (m_form != nullptr) {
        m_form->hide();
        m_form->deleteLater(); // one of its buttons may have asked for it
        m_form = nullptr;
    }
    if (chosen() == nullptr) {
        return;
    }
    static const model::FeatureValue kNone; // of a scene that has gone, until the form has too
    const FormTarget target{[this]() -> const void* {
                                const model::FeatureValue* shown = chosen();
                                return shown != nullptr ? shown : &kNone;
                            },
                            [this](const std::function<void(void*)>& apply) { change(apply); },
                            [this] {
                                return model::FieldContext{&m_state.scene(), nullptr};
                            }};
    m_form = new FieldForm(target, QStringLiteral("feature"), &m_state, this);
    m_form->setObjectName(QStringLiteral("featureForm"));
    m_form->addFields(formFields());
    m_form->finish();
    m_formPlace->addWidget(m_form);
}

void FeaturesDock::change(const std::function<void(void*)>& apply)
{
    const model::FeatureValue* before = chosen();
    if (before == nullptr) {
        return;
    }
    model::FeatureValue edited = *before;
    apply(&edited);
    std::ranges::sort(edited.templates);
    m_edited = std::move(edited);
    m_keep.start();
    if (QListWidgetItem* item = m_values->currentItem()) {
        m_isFilling = true;
        item->setIcon(featureSwatch(m_edited->color));
        m_isFilling = false;
    }
    m_preview->setFeature(&*m_edited);
    if (m_form->isOutdated()) {
        rebuildForm();
    } else {
        m_form->refresh();
    }
}

void FeaturesDock::keepChange()
{
    m_keep.stop();
    if (m_edited) {
        const model::FeatureValue edited = *std::exchange(m_edited, std::nullopt);
        if (findFeature(m_state.scene().features, edited.id) != nullptr) {
            changeFeature(m_state, edited, m_isWorn->isChecked());
        }
    }
}

void FeaturesDock::refreshBearers()
{
    if (!isVisible()) {
        return;
    }
    const int bearers = static_cast<int>(bearersOf(m_state.scene(), chosenId()).size());
    m_isWorn->setEnabled(bearers > 0);
    m_isWorn->setText(bearers > 0 ? tr("%n bear it and change with it", nullptr, bearers)
                                  : tr("Nobody bears it yet"));
}

void FeaturesDock::edit(model::FeatureId id)
{
    for (int row = 0; row < m_values->count(); ++row) {
        if (m_values->item(row)->data(kIdRole).toUInt() == id) {
            m_values->setCurrentRow(row);
            m_values->editItem(m_values->item(row));
            showRenaming(*m_values);
        }
    }
}

void FeaturesDock::fillKindMenu()
{
    m_kindMenu->clear();
    const model::FeatureKind* shown = kind();
    m_kindMenu->addAction(iconNamed("add"), tr("New Feature"), this, [this] {
        keepChange();
        addNamedKind();
    });
    m_kindMenu->addAction(tr("Rename…"), this, &FeaturesDock::renameShownKind)
        ->setEnabled(shown != nullptr);
    m_kindMenu
        ->addAction(iconNamed("delete"), tr("Remove"), this,
                    [this] {
                        if (const model::FeatureKind* gone = kind()) {
                            m_edited.reset();
                            removeKind(m_state, gone->id);
                        }
                    })
        ->setEnabled(shown != nullptr);
    m_kindMenu->addSeparator();
    m_kindMenu->addAction(tr("Save as a File…"), this, &FeaturesDock::exportShown)
        ->setEnabled(shown != nullptr);
    m_kindMenu->addAction(tr("Take from a File…"), this, &FeaturesDock::importFile);
}

void FeaturesDock::showKind(std::uint8_t kind)
{
    fill();
    m_kinds->setCurrentIndex(std::max(0, m_kinds->findData(uint{kind})));
}

void FeaturesDock::addNamedKind()
{
    if (!hasRoomForKind(m_state)) {
        return;
    }
    const auto name = nameAsked(tr("New Feature"), freeKindName(m_state));
    if (const std::uint8_t made = name ? addKind(m_state, *name) : std::uint8_t{0}; made != 0) {
        showKind(made);
    }
}

/// Nothing: the artist thought better of it.
std::optional<QString> FeaturesDock::nameAsked(const QString& title, const QString& proposal)
{
    QInputDialog dialog(this);
    dialog.setWindowTitle(title);
    dialog.setLabelText(tr("Name"));
    dialog.setTextValue(proposal);
    // The title is to be read whole.
    dialog.resize(std::max(dialog.sizeHint().width(), 40 * fontMetrics().averageCharWidth()),
                  dialog.sizeHint().height());
    return dialog.exec() == QDialog::Accepted ? std::optional(dialog.textValue()) : std::nullopt;
}

void FeaturesDock::renameShownKind()
{
    const model::FeatureKind* shown = kind();
    if (shown == nullptr) {
        return;
    }
    const std::uint8_t id = shown->id;
    if (const auto name = nameAsked(tr("Rename the Feature"), featureText(shown->name))) {
        (void)renameKind(m_state, id, *name);
    }
}

void FeaturesDock::exportShown()
{
    keepChange();
    const model::FeatureKind* shown = kind();
    if (shown == nullptr) {
        return;
    }
    const std::uint8_t id = shown->id;
    const QString ending = QLatin1Char('.') + QLatin1String(model::kFeatureFileEnding);
    QString path = QFileDialog::getSaveFileName(
        this, tr("Save the Feature"),
        inLastFolder(kFeatureFolder, m_state.document().path(), featureText(shown->name) + ending),
        tr("Features (*%1)").arg(ending));
    if (path.isEmpty()) {
        return;
    }
    rememberFolder(kFeatureFolder, path);
    path += path.endsWith(ending) ? QString() : ending;
    const auto saved = exportKind(m_state, id, path);
    m_state.showStatus(
        saved ? tr("Saved as %1").arg(path)
              : tr("%1 cannot be saved: %2").arg(path, model::translated(saved.error().said)));
}

void FeaturesDock::importFile()
{
    keepChange();
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Take Features"), inLastFolder(kFeatureFolder, m_state.document().path(), {}),
        tr("Features (*%1)").arg(QLatin1Char('.') + QLatin1String(model::kFeatureFileEnding)));
    if (path.isEmpty()) {
        return;
    }
    rememberFolder(kFeatureFolder, path);
    const model::FeatureKinds before = m_state.scene().features;
    const auto taken = importKinds(m_state, path);
    for (const model::FeatureKind& each : m_state.scene().features) {
        if (std::ranges::find(before, each) == before.end()) { // new, or with other values
            showKind(each.id);
            break;
        }
    }
    m_state.showStatus(taken ? tr("Features taken from %1").arg(path)
                             : model::translated(taken.error().said));
}

void FeaturesDock::showMenu(const QPoint& position)
{
    const QListWidgetItem* item = m_values->itemAt(position);
    if (item == nullptr) {
        return;
    }
    keepChange();
    QMenu menu(this);
    fillMenu(menu, static_cast<model::FeatureId>(item->data(kIdRole).toUInt()));
    menu.exec(m_values->viewport()->mapToGlobal(position));
}

void FeaturesDock::fillMenu(QMenu& menu, model::FeatureId id)
{
    const int row = m_values->currentRow();
    menu.addAction(iconNamed("to-brush"), tr("Paint It"), this,
                   [this, id] { paintFeature(m_state, id); });
    menu.addAction(iconNamed("give"), tr("Give to who is selected"), this,
                   [this, id] { giveFeature(m_state, id); });
    menu.addAction(tr("Select who bears it"), this, [this, id] { selectBearers(m_state, id); });
    menu.addSeparator();
    menu.addAction(tr("Rename"), this, [this, id] { edit(id); });
    menu.addAction(iconNamed("copy"), tr("Duplicate"), this, [this, id] { duplicate(id); });
    menu.addAction(tr("Up"), this, [this, id] { moveFeature(m_state, id, -1); })
        ->setEnabled(row > 0);
    menu.addAction(tr("Down"), this, [this, id] { moveFeature(m_state, id, 1); })
        ->setEnabled(row + 1 < m_values->count());
    menu.addSeparator();
    menu.addAction(iconNamed("delete"), tr("Remove"), this,
                   [this, id] { removeFeature(m_state, id); });
}

} // namespace crowd::widgets
