// SPDX-License-Identifier: MIT
#include "app/window/PreferencesDialog.h"

#include <QtCore/QSettings>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QKeySequenceEdit>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QTabWidget>
#include <QtWidgets/QTableWidget>
#include <QtWidgets/QVBoxLayout>

namespace crowd::app {

namespace {

const QString kTheme = QStringLiteral("preferences/theme");
const QString kButtons = QStringLiteral("preferences/paperMouse");
const QString kAutosave = QStringLiteral("preferences/autosaveSeconds");
const QString kMemory = QStringLiteral("preferences/keyframeMegabytes");
const QString kLanguage = QStringLiteral("preferences/language");

QString withoutMnemonic(QString text)
{
    return text.remove(QLatin1Char('&'));
}

} // namespace

Preferences Preferences::load()
{
    const QSettings settings;
    Preferences preferences;
    preferences.theme = widgets::themeNamed(settings.value(kTheme).toString());
    preferences.buttons = settings.value(kButtons).toBool() ? widgets::ButtonMapping::Paper
                                                            : widgets::ButtonMapping::Standard;
    preferences.autosaveSeconds = settings.value(kAutosave, preferences.autosaveSeconds).toInt();
    preferences.keyframeMegabytes = settings.value(kMemory, preferences.keyframeMegabytes).toInt();
    preferences.language = settings.value(kLanguage).toString();
    return preferences;
}

void Preferences::save() const
{
    QSettings settings;
    settings.setValue(kTheme, widgets::themeName(theme));
    settings.setValue(kButtons, buttons == widgets::ButtonMapping::Paper);
    settings.setValue(kAutosave, autosaveSeconds);
    settings.setValue(kMemory, keyframeMegabytes);
    settings.setValue(kLanguage, language);
}

PreferencesDialog::PreferencesDialog(widgets::ActionRegistry& actions, QWidget* parent)
    : QDialog(parent), m_actions(actions), m_theme(new QComboBox(this)),
      m_buttons(new QComboBox(this)), m_language(new QComboBox(this)),
      m_autosave(new QSpinBox(this)), m_memory(new QSpinBox(this))
{
    setWindowTitle(tr("Preferences"));
    auto* pages = new QTabWidget(this);
    pages->addTab(generalPage(), tr("General"));
    pages->addTab(shortcutsPage(), tr("Shortcuts"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &PreferencesDialog::savePreferences);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(pages);
    layout->addWidget(buttons);
    resize(560, 480);
}

QWidget* PreferencesDialog::generalPage()
{
    const Preferences now = Preferences::load();
    m_theme->addItems({tr("As the system"), tr("Light"), tr("Dark")});
    m_theme->setCurrentIndex(static_cast<int>(now.theme));
    m_buttons->addItem(tr("Left paints, right opens the brushes"));
    m_buttons->addItem(tr("Left a point, middle a circle, right a rectangle"));
    m_buttons->setCurrentIndex(now.buttons == widgets::ButtonMapping::Paper ? 1 : 0);
    m_language->addItem(tr("As the system"), QString());
    m_language->addItem(QStringLiteral("English"), QStringLiteral("en"));
    m_language->addItem(QStringLiteral("Deutsch"), QStringLiteral("de"));
    m_language->setCurrentIndex(std::max(0, m_language->findData(now.language)));
    m_autosave->setRange(0, 3600);
    m_autosave->setSingleStep(30);
    m_autosave->setSuffix(tr(" s"));
    m_autosave->setSpecialValueText(tr("Never"));
    m_autosave->setValue(now.autosaveSeconds);
    m_memory->setRange(64, 65536);
    m_memory->setSingleStep(64);
    m_memory->setSuffix(tr(" MB"));
    m_memory->setValue(now.keyframeMegabytes);

    auto* page = new QWidget(this);
    auto* form = new QFormLayout(page);
    form->addRow(tr("Theme"), m_theme);
    form->addRow(tr("Mouse buttons"), m_buttons);
    form->addRow(tr("Keep unsaved work every"), m_autosave);
    form->addRow(tr("Memory for keyframes"), m_memory);
    form->addRow(tr("Language"), m_language);
    auto* note = new QLabel(tr("Memory and language change when Crowdbrush starts again."), page);
    note->setWordWrap(true);
    form->addRow(note);
    return page;
}

QWidget* PreferencesDialog::shortcutsPage()
{
    auto* page = new QWidget(this);
    auto* table = new QTableWidget(static_cast<int>(m_actions.specs().size()), 2, page);
    table->setHorizontalHeaderLabels({tr("Action"), tr("Keys")});
    table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    table->setColumnWidth(1, 180);
    table->verticalHeader()->hide();
    int row = 0;
    for (const widgets::ActionSpec& spec : m_actions.specs()) {
        QAction* action = m_actions.action(spec.id);
        auto* name = new QTableWidgetItem(action->icon(), withoutMnemonic(action->text()));
        name->setFlags(Qt::ItemIsEnabled);
        table->setItem(row, 0, name);
        auto* keys = new QKeySequenceEdit(action->shortcut(), table);
        const std::string id = spec.id;
        connect(keys, &QKeySequenceEdit::editingFinished, this, [this, keys, id, action] {
            QAction* owner = m_actions.actionWithShortcut(keys->keySequence());
            if (owner != nullptr && owner != action) {
                keys->setKeySequence(action->shortcut()); // taken: the tool tip says by what
                keys->setToolTip(
                    tr("Those keys belong to “%1”.").arg(withoutMnemonic(owner->text())));
                return;
            }
            m_actions.setShortcut(id, keys->keySequence());
        });
        table->setCellWidget(row, 1, keys);
        ++row;
    }
    auto* reset = new QPushButton(tr("All Back to Defaults"), page);
    connect(reset, &QPushButton::clicked, this, [this, table] {
        m_actions.resetShortcuts();
        for (int i = 0; i < table->rowCount(); ++i) {
            const auto& spec = m_actions.specs()[static_cast<std::size_t>(i)];
            static_cast<QKeySequenceEdit*>(table->cellWidget(i, 1))
                ->setKeySequence(m_actions.action(spec.id)->shortcut());
        }
    });
    auto* layout = new QVBoxLayout(page);
    layout->addWidget(table);
    layout->addWidget(reset, 0, Qt::AlignRight);
    return page;
}

void PreferencesDialog::savePreferences()
{
    Preferences preferences;
    preferences.theme = static_cast<widgets::Theme>(m_theme->currentIndex());
    preferences.buttons = m_buttons->currentIndex() == 1 ? widgets::ButtonMapping::Paper
                                                         : widgets::ButtonMapping::Standard;
    preferences.autosaveSeconds = m_autosave->value();
    preferences.keyframeMegabytes = m_memory->value();
    preferences.language = m_language->currentData().toString();
    preferences.save();
}

} // namespace crowd::app
