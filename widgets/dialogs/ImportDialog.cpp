// SPDX-License-Identifier: MIT
#include "widgets/dialogs/ImportDialog.h"

#include <cmath>
#include <numbers>

#include <QtCore/QCoreApplication>
#include <QtCore/QFileInfo>
#include <QtCore/QSignalBlocker>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QVBoxLayout>

#include "model/base/Translated.h"
#include "model/gltf/GltfImport.h"
#include "widgets/dialogs/ClipTable.h"
#include "widgets/dialogs/TemplatePreview.h"
#include "widgets/forms/NumberBox.h"

namespace crowd::widgets {

namespace {

constexpr int kPatienceMs = 250;
constexpr float kQuarter = std::numbers::pi_v<float> / 2.0F;
constexpr qsizetype kMostRemarks = 5;

struct UpAxis
{
    const char* name;
    glm::quat toY;
};

/// Rotations that bring the file's up axis to Y.
const std::vector<UpAxis>& upAxes()
{
    static const std::vector<UpAxis> kAxes{
        {QT_TRANSLATE_NOOP("ImportDialog", "Y up (glTF)"), {1, 0, 0, 0}},
        {QT_TRANSLATE_NOOP("ImportDialog", "Z up"), glm::angleAxis(-kQuarter, glm::vec3(1, 0, 0))},
        {QT_TRANSLATE_NOOP("ImportDialog", "Z down"), glm::angleAxis(kQuarter, glm::vec3(1, 0, 0))},
        {QT_TRANSLATE_NOOP("ImportDialog", "X up"), glm::angleAxis(kQuarter, glm::vec3(0, 0, 1))},
        {QT_TRANSLATE_NOOP("ImportDialog", "X down"),
         glm::angleAxis(-kQuarter, glm::vec3(0, 0, 1))},
        {QT_TRANSLATE_NOOP("ImportDialog", "Y down"),
         glm::angleAxis(2.0F * kQuarter, glm::vec3(0, 0, 1))},
    };
    return kAxes;
}

/// Which axis and which turn about Y make up a rotation; the nearest axis.
std::pair<int, float> splitRotation(const glm::quat& rotation)
{
    int best = 0;
    float bestUp = -2.0F;
    for (std::size_t i = 0; i < upAxes().size(); ++i) {
        const glm::quat rest = rotation * glm::conjugate(upAxes()[i].toY);
        const float up = (rest * glm::vec3(0, 1, 0)).y;
        if (up > bestUp) {
            bestUp = up;
            best = static_cast<int>(i);
        }
    }
    const glm::quat turn = rotation * glm::conjugate(upAxes()[static_cast<std::size_t>(best)].toY);
    const glm::vec3 front = turn * glm::vec3(0, 0, 1);
    return {best, std::atan2(front.x, front.z)};
}

QDoubleSpinBox* numberBox(double low, double high, double step, int decimals, QWidget* parent)
{
    auto* box = new NumberBox(parent);
    box->setRange(low, high);
    box->setSingleStep(step);
    box->setDecimals(decimals);
    box->setKeyboardTracking(false);
    return box;
}

} // namespace

ImportDialog::ImportDialog(const QString& path, model::TemplatePtr asset,
                           model::KeyframeStore& keyframes, QWidget* parent)
    : QDialog(parent), m_path(path), m_asset(std::move(asset)),
      m_proposal(model::proposeImport(*m_asset)), m_preview(new TemplatePreview(keyframes, this)),
      m_scale(numberBox(0.00001, 10000.0, 0.1, 5, this)),
      m_height(numberBox(0.001, 10000.0, 0.1, 3, this)), m_upAxis(new QComboBox(this)),
      m_turn(numberBox(-180.0, 180.0, 15.0, 1, this)),
      m_groundOffset(numberBox(-1000.0, 1000.0, 0.01, 3, this)),
      m_rootMotion(new QCheckBox(tr("Stay on the spot; the program moves the character"), this)),
      m_remarks(new QLabel(this)), m_clips(new ClipTable(*m_asset, this))
{
    setWindowTitle(tr("Import %1").arg(QFileInfo(path).fileName()));
    for (const UpAxis& up : upAxes()) {
        m_upAxis->addItem(QCoreApplication::translate("ImportDialog", up.name));
    }
    m_turn->setSuffix(QStringLiteral("°"));
    m_scale->setObjectName(QStringLiteral("importScale"));
    m_height->setObjectName(QStringLiteral("importHeight"));
    m_turn->setWrapping(true);
    m_height->setSuffix(tr(" m"));
    m_groundOffset->setSuffix(tr(" m"));
    m_scale->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    buildLayout();
    propose();
    m_refresh.setSingleShot(true);
    m_refresh.setInterval(kPatienceMs);
    connect(&m_refresh, &QTimer::timeout, this, &ImportDialog::refresh);
    const auto later = [this] { m_refresh.start(); };
    for (QDoubleSpinBox* box : {m_scale, m_turn, m_groundOffset}) {
        connect(box, &QDoubleSpinBox::valueChanged, this, later);
    }
    connect(m_height, &QDoubleSpinBox::valueChanged, this, &ImportDialog::scaleToHeight);
    connect(m_upAxis, &QComboBox::currentIndexChanged, this, later);
    connect(m_rootMotion, &QCheckBox::toggled, this, later);
    connect(m_clips, &QTableWidget::currentCellChanged, this,
            [this] { m_preview->show(m_asset, m_clips->shownClip()); });
    refresh();
}

void ImportDialog::buildLayout()
{
    auto* toGround = new QPushButton(tr("To the &Ground"), this);
    toGround->setToolTip(tr("Raise or lower it until its lowest point is on the ground"));
    toGround->setAutoDefault(false);
    connect(toGround, &QPushButton::clicked, this, &ImportDialog::putOnGround);
    auto* raise = new QHBoxLayout;
    raise->addWidget(m_groundOffset, 1);
    raise->addWidget(toGround);
    auto* form = new QFormLayout;
    form->addRow(tr("Height"), m_height);
    form->addRow(tr("Scale"), m_scale);
    form->addRow(tr("Up axis"), m_upAxis);
    form->addRow(tr("Turn"), m_turn);
    form->addRow(tr("Raise"), raise);
    form->addRow(tr("Root motion"), m_rootMotion);
    m_remarks->setWordWrap(true);
    m_remarks->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_import = m_buttons->addButton(tr("&Import"), QDialogButtonBox::AcceptRole);
    m_import->setDefault(true);
    m_import->setObjectName(QStringLiteral("import"));
    QPushButton* proposal = m_buttons->addButton(tr("As &Proposed"), QDialogButtonBox::ResetRole);
    connect(proposal, &QPushButton::clicked, this, &ImportDialog::propose);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* right = new QVBoxLayout;
    right->addLayout(form);
    right->addWidget(m_remarks);
    right->addWidget(m_clips, 1);
    auto* columns = new QHBoxLayout;
    columns->addWidget(m_preview, 1);
    columns->addLayout(right, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(columns, 1);
    layout->addWidget(m_buttons);
    resize(960, 560);
}

void ImportDialog::offerRest(int count)
{
    m_importAll = m_buttons->addButton(tr("Import &All"), QDialogButtonBox::ActionRole);
    m_importAll->setObjectName(QStringLiteral("importAll"));
    m_importAll->setAutoDefault(false);
    m_importAll->setToolTip(
        tr("This one as it is here, and the %n other file(s) as proposed", nullptr, count));
    connect(m_importAll, &QPushButton::clicked, this, [this] {
        m_isForRest = true;
        accept();
    });
}

QString ImportDialog::remarks() const
{
    QStringList notes;
    for (const model::Message& reason : m_proposal.reasons) {
        notes << QStringLiteral("• ") + model::translated(reason);
    }
    for (const model::Message& warning : m_asset->warnings) {
        notes << QStringLiteral("⚠ ") + model::translated(warning);
    }
    const qsizetype more = notes.size() - kMostRemarks;
    if (more > 0) {
        m_remarks->setToolTip(notes.join(QLatin1Char('\n')));
        notes = notes.mid(0, kMostRemarks);
        notes << tr("and %n more", nullptr, static_cast<int>(more));
    }
    return notes.join(QLatin1Char('\n'));
}

void ImportDialog::propose()
{
    const auto [axis, turn] = splitRotation(m_proposal.settings.rotation);
    m_upAxis->setCurrentIndex(axis);
    m_turn->setValue(static_cast<double>(turn) * 180.0 / std::numbers::pi);
    m_scale->setValue(static_cast<double>(m_proposal.settings.scale));
    m_groundOffset->setValue(static_cast<double>(m_proposal.settings.groundOffset));
    m_rootMotion->setChecked(m_proposal.settings.removeRootMotion);
}

/// Its size follows the scale.
void ImportDialog::scaleToHeight(double metres)
{
    if (m_asset->height > 0.0F) {
        m_scale->setValue(metres / static_cast<double>(m_asset->height) *
                          static_cast<double>(m_shown.scale));
    }
}

void ImportDialog::putOnGround()
{
    const double lift = static_cast<double>(m_shown.groundOffset - m_asset->bounds.low.y);
    m_groundOffset->setValue(lift);
}

glm::quat ImportDialog::rotation() const
{
    const auto turn = static_cast<float>(m_turn->value() * std::numbers::pi / 180.0);
    return glm::normalize(glm::angleAxis(turn, glm::vec3(0, 1, 0)) *
                          upAxes()[static_cast<std::size_t>(m_upAxis->currentIndex())].toY);
}

model::ImportSettings ImportDialog::settings() const
{
    model::ImportSettings settings;
    settings.scale = static_cast<float>(m_scale->value());
    settings.rotation = rotation();
    settings.groundOffset = static_cast<float>(m_groundOffset->value());
    settings.removeRootMotion = m_rootMotion->isChecked();
    return settings;
}

std::vector<float> ImportDialog::clipSpeeds() const
{
    return m_clips->editedSpeeds();
}

std::vector<std::optional<model::ClipRole>> ImportDialog::clipRoles() const
{
    return m_clips->editedRoles();
}

void ImportDialog::refresh()
{
    m_task.cancel();
    m_task.start(
        [path = m_path.toStdString(), settings = settings()](const TaskReport& report) {
            return model::importTemplate(
                path, settings, [&report](float) { return !report.stop().stop_requested(); });
        },
        [this, settings = settings()](const model::Result<model::TemplatePtr>& asset) {
            take(asset, settings);
        });
}

void ImportDialog::take(const model::Result<model::TemplatePtr>& asset,
                        const model::ImportSettings& settings)
{
    m_import->setEnabled(asset.isOk());
    if (m_importAll != nullptr) {
        m_importAll->setEnabled(asset.isOk());
    }
    if (!asset) {
        m_remarks->setText(model::translated(asset.error()));
        return;
    }
    m_asset = asset.value();
    m_shown = settings;
    const QSignalBlocker blocker(m_height); // it follows the scale here, not the other way round
    m_height->setValue(static_cast<double>(m_asset->height));
    m_remarks->setText(remarks());
    m_clips->follow(*m_asset);
    m_preview->show(m_asset, m_clips->shownClip());
}

} // namespace crowd::widgets
