// SPDX-License-Identifier: MIT
#include "app/window/PreferencesDialog.h"

#include <algorithm>
#include <array>

#include <QtCore/QSettings>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QTabWidget>
#include <QtWidgets/QVBoxLayout>

#include "app/window/Language.h"
#include "app/window/ShortcutsPage.h"
#include "widgets/forms/NumberBox.h"

namespace crowd::app {

namespace {

const QString kTheme = QStringLiteral("preferences/theme");
const QString kButtons = QStringLiteral("preferences/paperMouse");
const QString kQuality = QStringLiteral("preferences/pictureQuality");
const QString kSamples = QStringLiteral("preferences/samples");
const QString kAutosave = QStringLiteral("preferences/autosaveSeconds");
const QString kMemory = QStringLiteral("preferences/keyframeMegabytes");
const QString kUndoMemory = QStringLiteral("preferences/undoMegabytes");
const QString kGroups = QStringLiteral("preferences/groupsStrokes");
const QString kLanguage = QStringLiteral("preferences/language");
const QString kWelcome = QStringLiteral("preferences/showsWelcome");

constexpr double kSecondsInAMinute = 60.0;
const std::array kQualities{QStringLiteral("automatic"), QStringLiteral("fast"),
                            QStringLiteral("best")}; ///< as they are kept

widgets::PictureQuality qualityNamed(const QString& name)
{
    const auto found = std::ranges::find(kQualities, name);
    return found == kQualities.end()
               ? widgets::PictureQuality::Automatic
               : static_cast<widgets::PictureQuality>(found - kQualities.begin());
}

constexpr std::array kSampleCounts{0, 2, 4, 8};

/// One of those that are offered.
int samplesLike(int samples)
{
    const auto next = std::ranges::lower_bound(kSampleCounts, samples);
    return next == kSampleCounts.end() ? kSampleCounts.back() : *next;
}

} // namespace

Preferences Preferences::load()
{
    const QSettings settings;
    Preferences preferences;
    preferences.theme = widgets::themeNamed(settings.value(kTheme).toString());
    preferences.buttons = settings.value(kButtons).toBool() ? widgets::ButtonMapping::Paper
                                                            : widgets::ButtonMapping::Standard;
    preferences.quality = qualityNamed(settings.value(kQuality).toString());
    preferences.samples = samplesLike(settings.value(kSamples, preferences.samples).toInt());
    preferences.autosaveSeconds = settings.value(kAutosave, preferences.autosaveSeconds).toInt();
    preferences.keyframeMegabytes = settings.value(kMemory, preferences.keyframeMegabytes).toInt();
    preferences.undoMegabytes = settings.value(kUndoMemory, preferences.undoMegabytes).toInt();
    preferences.groupsStrokes = settings.value(kGroups).toBool();
    preferences.language = settings.value(kLanguage).toString();
    preferences.showsWelcome = settings.value(kWelcome, true).toBool();
    return preferences;
}

void Preferences::save() const
{
    QSettings settings;
    settings.setValue(kTheme, widgets::themeName(theme));
    settings.setValue(kButtons, buttons == widgets::ButtonMapping::Paper);
    settings.setValue(kQuality, kQualities[static_cast<std::size_t>(quality)]);
    settings.setValue(kSamples, samples);
    settings.setValue(kAutosave, autosaveSeconds);
    settings.setValue(kMemory, keyframeMegabytes);
    settings.setValue(kUndoMemory, undoMegabytes);
    settings.setValue(kGroups, groupsStrokes);
    settings.setValue(kLanguage, language);
    settings.setValue(kWelcome, showsWelcome);
}

PreferencesDialog::PreferencesDialog(widgets::ActionRegistry& actions, QWidget* parent)
    : QDialog(parent), m_before(Preferences::load()), m_shortcuts(new ShortcutsPage(actions, this)),
      m_theme(new QComboBox(this)), m_buttons(new QComboBox(this)), m_quality(new QComboBox(this)),
      m_samples(new QComboBox(this)), m_language(new QComboBox(this)),
      m_autosave(new widgets::NumberBox(this)), m_memory(new QSpinBox(this)),
      m_undoMemory(new QSpinBox(this)), m_groups(new QCheckBox(this)),
      m_languageNote(new QLabel(this)), m_welcome(new QCheckBox(this))
{
    setWindowTitle(tr("Preferences"));
    fill();
    auto* pages = new QTabWidget(this);
    pages->addTab(generalPage(), tr("General"));
    pages->addTab(m_shortcuts, tr("Shortcuts"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &PreferencesDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &PreferencesDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(pages);
    layout->addWidget(buttons);
    resize(600, 520);
    for (QComboBox* box : {m_theme, m_buttons, m_quality, m_samples, m_language}) {
        connect(box, &QComboBox::currentIndexChanged, this, &PreferencesDialog::choose);
    }
    connect(m_autosave, &QDoubleSpinBox::valueChanged, this, &PreferencesDialog::choose);
    for (QSpinBox* box : {m_memory, m_undoMemory}) {
        connect(box, &QSpinBox::valueChanged, this, &PreferencesDialog::choose);
    }
    for (QCheckBox* box : {m_groups, m_welcome}) {
        connect(box, &QCheckBox::toggled, this, &PreferencesDialog::choose);
    }
}

void PreferencesDialog::fill()
{
    m_theme->addItems({tr("As the system"), tr("Light"), tr("Dark")});
    m_theme->setCurrentIndex(static_cast<int>(m_before.theme));
    m_buttons->addItem(tr("Left paints, right opens the brushes"));
    m_buttons->addItem(tr("Left a point, middle a circle, right a rectangle"));
    m_buttons->setCurrentIndex(m_before.buttons == widgets::ButtonMapping::Paper ? 1 : 0);
    m_quality->addItems({tr("Automatic"), tr("Fast"), tr("Best")});
    m_quality->setCurrentIndex(static_cast<int>(m_before.quality));
    m_quality->setToolTip(tr("Automatic: smooth while it can keep up, and perfect when nothing "
                             "moves. Fast spares an old machine; best is always smooth."));
    for (const int samples : kSampleCounts) {
        m_samples->addItem(samples == 0 ? tr("Found in the picture")
                                        : tr("%n samples a pixel", nullptr, samples),
                           samples);
    }
    m_samples->setCurrentIndex(std::max(0, m_samples->findData(m_before.samples)));
    m_samples->setToolTip(tr("While something moves, and as many as the graphics card offers. A "
                             "picture that rests is always smooth."));
    m_language->addItem(tr("As the system"), QString());
    for (const Language& language : languages()) {
        m_language->addItem(language.name, language.code);
    }
    m_language->setCurrentIndex(std::max(0, m_language->findData(m_before.language)));
    m_languageNote->setText(tr("The language changes when this page closes."));
    m_languageNote->setWordWrap(true);
    m_languageNote->setVisible(false);
    m_autosave->setRange(0.0, 60.0);
    m_autosave->setDecimals(1);
    m_autosave->setSingleStep(0.5);
    m_autosave->setSuffix(tr(" min"));
    m_autosave->setSpecialValueText(tr("Never"));
    m_autosave->setValue(m_before.autosaveSeconds / kSecondsInAMinute);
    fillMemory(*m_memory, 64, m_before.keyframeMegabytes);
    m_memory->setToolTip(tr("Whose animation finds no room stands still."));
    fillMemory(*m_undoMemory, 16, m_before.undoMegabytes);
    m_undoMemory->setToolTip(tr("What exceeds it is kept in a temporary file on disk."));
    m_groups->setText(tr("Take back short strokes in a row together"));
    m_groups->setToolTip(tr("Clicks and dabs that follow each other within a second"));
    m_groups->setChecked(m_before.groupsStrokes);
    m_welcome->setText(tr("Show the welcome page"));
    m_welcome->setChecked(m_before.showsWelcome);
}

void PreferencesDialog::fillMemory(QSpinBox& box, int least, int megabytes)
{
    box.setRange(least, 65536);
    box.setSingleStep(least);
    box.setSuffix(tr(" MB"));
    box.setValue(megabytes);
    box.setKeyboardTracking(false); // not at every digit
}

QWidget* PreferencesDialog::generalPage()
{
    auto* page = new QWidget(this);
    auto* form = new QFormLayout(page);
    form->setVerticalSpacing(10);
    form->setContentsMargins(14, 14, 14, 14);
    form->addRow(tr("Theme"), m_theme);
    form->addRow(tr("Mouse buttons of the brushes"), m_buttons);
    form->addRow(tr("Quality of the picture"), m_quality);
    form->addRow(tr("Smooth edges"), m_samples);
    form->addRow(tr("Keep unsaved work every"), m_autosave);
    form->addRow(tr("Memory for prepared animations"), m_memory);
    form->addRow(tr("Memory for undo"), m_undoMemory);
    form->addRow(tr("Undo"), m_groups);
    form->addRow(tr("Language"), m_language);
    form->addRow(QString(), m_languageNote);
    form->addRow(tr("At start"), m_welcome);
    return page;
}

Preferences PreferencesDialog::chosen() const
{
    Preferences preferences;
    preferences.theme = static_cast<widgets::Theme>(m_theme->currentIndex());
    preferences.buttons = m_buttons->currentIndex() == 1 ? widgets::ButtonMapping::Paper
                                                         : widgets::ButtonMapping::Standard;
    preferences.quality = static_cast<widgets::PictureQuality>(m_quality->currentIndex());
    preferences.samples = m_samples->currentData().toInt();
    preferences.autosaveSeconds = qRound(m_autosave->value() * kSecondsInAMinute);
    preferences.keyframeMegabytes = m_memory->value();
    preferences.undoMegabytes = m_undoMemory->value();
    preferences.groupsStrokes = m_groups->isChecked();
    preferences.language = m_language->currentData().toString();
    preferences.showsWelcome = m_welcome->isChecked();
    return preferences;
}

void PreferencesDialog::choose()
{
    const Preferences now = chosen();
    m_languageNote->setVisible(now.language != m_before.language);
    Q_EMIT changed(now);
}

void PreferencesDialog::accept()
{
    m_shortcuts->apply();
    const Preferences now = chosen();
    now.save();
    QDialog::accept();
    if (now.language != m_before.language) {
        Q_EMIT languageChosen(now.language); // once nothing of the dialog is in the way
    }
}

void PreferencesDialog::reject()
{
    if (chosen() != m_before) {
        Q_EMIT changed(m_before);
    }
    QDialog::reject();
}

} // namespace crowd::app
