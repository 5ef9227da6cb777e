// SPDX-License-Identifier: MIT
#include "widgets/docks/PresetsDock.h"

#include <QtCore/QCoreApplication>
#include <QtGui/QAction>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/base/Translated.h"
#include "widgets/forms/LastFolder.h"
#include "widgets/forms/PanelButton.h"
#include "widgets/state/PresetUse.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kPresetIcon = 32; ///< logical pixels
const QString kPresetFolder = QStringLiteral("presets/folder");

QString presetFilter()
{
    return PresetsDock::tr("Brush presets (*.brush)");
}

} // namespace

PresetsDock::PresetsDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Presets"), "presets", parent), m_state(state), m_presets(model::presetFolder()),
      m_search(new QLineEdit(this)), m_list(new QListWidget(this)), m_note(new QLabel(this))
{
    m_search->setPlaceholderText(tr("Search names and #tags"));
    m_search->setClearButtonEnabled(true);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setIconSize({kPresetIcon, kPresetIcon});
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    m_note->setObjectName(QStringLiteral("presetsNote"));
    m_note->setWordWrap(true);
    m_note->setMargin(4);
    // Names of files have no end of words: they do not size the window.
    m_note->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(m_search);
    layout->addWidget(m_note);
    layout->addWidget(m_list, 1);
    layout->addWidget(buttons());
    setWidget(content);
    connectParts();
    fill();
}

QWidget* PresetsDock::buttons()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](const char* icon, const QString& tip, const char* name, auto act) {
        QToolButton* button = panelButton(row, icon, tip, name);
        layout->addWidget(button);
        connect(button, &QToolButton::clicked, this, act);
    };
    add("add", tr("Keep the brush as it is set now"), "keepPreset", &PresetsDock::add);
    add("import", tr("Take presets from files"), "importPresets", &PresetsDock::importFiles);
    layout->addStretch(1);
    const auto remove = [this] {
        if (const QListWidgetItem* item = m_list->currentItem()) {
            say(m_presets.remove(item->data(kIdRole).toString()));
        }
    };
    add("delete", tr("Remove the chosen preset"), "removePreset", remove);
    removeByKey(*m_list, remove);
    return row;
}

void PresetsDock::connectParts()
{
    connect(&m_presets, &BrushPresets::changed, this, &PresetsDock::fill);
    connect(m_search, &QLineEdit::textChanged, this, &PresetsDock::filter);
    connect(m_list, &QListWidget::itemClicked, this,
            [this](const QListWidgetItem* item) { use(item->data(kIdRole).toString()); });
    connect(m_list, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        if (!m_isFilling) {
            // Once the field for the name is closed: the list that it belongs to is filled anew.
            QMetaObject::invokeMethod(
                this,
                [this, former = item->data(kIdRole).toString(), name = item->text()] {
                    rename(former, name);
                },
                Qt::QueuedConnection);
        }
    });
    connect(m_list, &QListWidget::customContextMenuRequested, this, &PresetsDock::showMenu);
}

void PresetsDock::rename(const QString& former, const QString& name)
{
    const auto result = m_presets.rename(former, name);
    say(result);
    if (!result) {
        fill();
    }
}

void PresetsDock::fill()
{
    m_isFilling = true;
    m_list->clear();
    for (const BrushPreset& preset : m_presets.all()) {
        const ToolInfo& tool = toolInfo(toolOf(preset.kind));
        auto* item = new QListWidgetItem(presetPicture(preset), preset.name, m_list);
        item->setData(kIdRole, preset.name);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setToolTip(tr("%1: a click sets it so. F2 gives another name; words with # are tags.")
                             .arg(QCoreApplication::translate("Tools", tool.name)));
    }
    m_isFilling = false;
    QStringList notes = m_presets.problems();
    if (notes.isEmpty() && m_presets.all().empty()) {
        notes << tr("Brushes that you set well can be kept here.");
    }
    m_note->setText(notes.join(QLatin1Char('\n')));
    m_note->setToolTip(m_presets.problems().join(QLatin1Char('\n')));
    m_note->setVisible(!notes.isEmpty());
    filter();
}

/// All words of the search are in the name.
void PresetsDock::filter()
{
    const QStringList words = m_search->text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    for (int row = 0; row < m_list->count(); ++row) {
        QListWidgetItem* item = m_list->item(row);
        bool isFound = true;
        for (const QString& word : words) {
            isFound = isFound && item->text().contains(word, Qt::CaseInsensitive);
        }
        item->setHidden(!isFound);
    }
}

void PresetsDock::use(const QString& name)
{
    if (const BrushPreset* preset = m_presets.find(name)) {
        usePreset(m_state, *preset);
    }
}

void PresetsDock::add()
{
    const model::BrushSettings* brush = m_state.activeBrush();
    if (brush == nullptr) {
        m_state.showStatus(tr("Choose a brush first: presets keep how it is set."));
        return;
    }
    const QString name =
        m_presets.freeName(QCoreApplication::translate("Tools", toolInfo(m_state.tool()).name));
    const auto saved = m_presets.save(name, *brush);
    say(saved);
    if (saved) {
        m_search->clear();
        edit(name);
    }
}

void PresetsDock::edit(const QString& name)
{
    for (int row = 0; row < m_list->count(); ++row) {
        if (m_list->item(row)->data(kIdRole).toString() == name) {
            m_list->setCurrentRow(row);
            m_list->editItem(m_list->item(row));
            return;
        }
    }
}

void PresetsDock::showMenu(const QPoint& position)
{
    const QListWidgetItem* item = m_list->itemAt(position);
    if (item == nullptr) {
        return;
    }
    const QString name = item->data(kIdRole).toString();
    QMenu menu(this);
    menu.addAction(tr("Rename"), this, [this, name] { edit(name); });
    menu.addAction(tr("Set to the brush of now"), this, [this, name] {
        if (const BrushPreset* preset = m_presets.find(name)) {
            say(m_presets.save(name, m_state.brush(preset->kind)));
        }
    });
    menu.addAction(tr("Save as a file…"), this, [this, name] { exportTo(name); });
    menu.addSeparator();
    menu.addAction(tr("Remove"), this, [this, name] { say(m_presets.remove(name)); });
    menu.exec(m_list->viewport()->mapToGlobal(position));
}

void PresetsDock::importFiles()
{
    const QStringList files = QFileDialog::getOpenFileNames(
        this, tr("Take Presets"), inLastFolder(kPresetFolder, m_state.document().path(), {}),
        presetFilter());
    for (const QString& file : files) {
        rememberFolder(kPresetFolder, file);
        const auto taken = m_presets.importFile(file);
        if (!taken) {
            say(taken.error());
        }
    }
}

void PresetsDock::exportTo(const QString& name)
{
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Save Preset"),
        inLastFolder(kPresetFolder, m_state.document().path(), name + QStringLiteral(".brush")),
        presetFilter());
    if (!path.isEmpty()) {
        rememberFolder(kPresetFolder, path);
        say(m_presets.exportFile(name, path));
    }
}

void PresetsDock::say(const model::Result<void>& result)
{
    if (!result) {
        m_state.showStatus(model::translated(result.error()));
    }
}

} // namespace crowd::widgets
