// SPDX-License-Identifier: MIT
#include "widgets/dialogs/ImportDialog.h"

#include <cmath>
#include <limits>

#include <QtCore/QCoreApplication>
#include <QtCore/QFileInfo>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTableWidget>
#include <QtWidgets/QVBoxLayout>

#include "model/gltf/GltfImport.h"
#include "widgets/dialogs/TemplatePreview.h"

namespace crowd::widgets {

namespace {

constexpr int kPatienceMs = 250;
constexpr float kQuarter = 1.57079633F;

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
    auto* box = new QDoubleSpinBox(parent);
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
      m_scale(numberBox(0.00001, 10000.0, 0.1, 5, this)), m_upAxis(new QComboBox(this)),
      m_turn(numberBox(-180.0, 180.0, 15.0, 1, this)),
      m_groundOffset(numberBox(-1000.0, 1000.0, 0.01, 3, this)),
      m_rootMotion(new QCheckBox(tr("Walk on the spot; the program moves the character"), this)),
      m_height(new QLabel(this)), m_clips(new QTableWidget(this))
{
    setWindowTitle(tr("Import %1").arg(QFileInfo(path).fileName()));
    buildClips();
    buildForm();
    m_refresh.setSingleShot(true);
    m_refresh.setInterval(kPatienceMs);
    connect(&m_refresh, &QTimer::timeout, this, &ImportDialog::refresh);
    refresh();
}

ImportDialog::~ImportDialog() = default;

void ImportDialog::buildForm()
{
    const auto [axis, turn] = splitRotation(m_proposal.settings.rotation);
    for (const UpAxis& up : upAxes()) {
        m_upAxis->addItem(QCoreApplication::translate("ImportDialog", up.name));
    }
    m_upAxis->setCurrentIndex(axis);
    m_turn->setValue(static_cast<double>(turn) * 180.0 / 3.14159265358979);
    m_turn->setSuffix(QStringLiteral("°"));
    m_scale->setValue(static_cast<double>(m_proposal.settings.scale));
    m_groundOffset->setValue(static_cast<double>(m_proposal.settings.groundOffset));
    m_groundOffset->setSuffix(tr(" m"));
    m_rootMotion->setChecked(m_proposal.settings.removeRootMotion);

    auto* form = new QFormLayout;
    form->addRow(tr("Scale"), m_scale);
    form->addRow(tr("Height"), m_height);
    form->addRow(tr("Up axis"), m_upAxis);
    form->addRow(tr("Turn"), m_turn);
    form->addRow(tr("Raise"), m_groundOffset);
    form->addRow(tr("Root motion"), m_rootMotion);

    QStringList notes;
    for (const std::string& reason : m_proposal.reasons) {
        notes << QStringLiteral("• ") + QString::fromStdString(reason);
    }
    for (const std::string& warning : m_asset->warnings) {
        notes << QStringLiteral("⚠ ") + QString::fromStdString(warning);
    }
    auto* remarks = new QLabel(notes.join(QLatin1Char('\n')), this);
    remarks->setWordWrap(true);
    remarks->setTextInteractionFlags(Qt::TextSelectableByMouse);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->addButton(tr("&Import"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* right = new QVBoxLayout;
    right->addLayout(form);
    right->addWidget(remarks);
    right->addWidget(m_clips, 1);
    auto* columns = new QHBoxLayout;
    columns->addWidget(m_preview, 1);
    columns->addLayout(right, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(columns, 1);
    layout->addWidget(buttons);
    resize(760, 520);

    const auto later = [this] { m_refresh.start(); };
    for (QDoubleSpinBox* box : {m_scale, m_turn, m_groundOffset}) {
        connect(box, &QDoubleSpinBox::valueChanged, this, later);
    }
    connect(m_upAxis, &QComboBox::currentIndexChanged, this, later);
    connect(m_rootMotion, &QCheckBox::toggled, this, later);
    connect(m_clips, &QTableWidget::itemSelectionChanged, this, later);
}

void ImportDialog::buildClips()
{
    m_clips->setColumnCount(3);
    m_clips->setHorizontalHeaderLabels({tr("Clip"), tr("Length"), tr("Ground speed")});
    m_clips->setRowCount(static_cast<int>(m_asset->clips.size()));
    m_clips->verticalHeader()->hide();
    m_clips->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_clips->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_clips->setSelectionMode(QAbstractItemView::SingleSelection);
    for (int row = 0; row < m_clips->rowCount(); ++row) {
        const model::Clip& clip = m_asset->clips[static_cast<std::size_t>(row)];
        auto* name = new QTableWidgetItem(QString::fromStdString(clip.name));
        auto* length = new QTableWidgetItem(
            tr("%1 s").arg(QLocale().toString(static_cast<double>(clip.seconds), 'f', 2)));
        for (QTableWidgetItem* item : {name, length}) {
            item->setFlags(item->flags() & ~Qt::ItemIsEditable);
        }
        auto* speed = numberBox(0.0, 100.0, 0.05, 2, m_clips);
        speed->setSuffix(tr(" m/s"));
        speed->setFrame(false);
        m_clips->setItem(row, 0, name);
        m_clips->setItem(row, 1, length);
        m_clips->setCellWidget(row, 2, speed);
    }
    m_clips->selectRow(m_asset->defaultClip);
}

glm::quat ImportDialog::rotation() const
{
    const float turn = static_cast<float>(m_turn->value() * 3.14159265358979 / 180.0);
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
    std::vector<float> speeds;
    bool isAnyEdited = false;
    for (int row = 0; row < m_clips->rowCount(); ++row) {
        const auto* box = static_cast<QDoubleSpinBox*>(m_clips->cellWidget(row, 2));
        const bool isEdited = std::abs(box->value() - box->property("fromFile").toDouble()) > 0.001;
        isAnyEdited = isAnyEdited || isEdited;
        speeds.push_back(isEdited ? static_cast<float>(box->value())
                                  : std::numeric_limits<float>::quiet_NaN());
    }
    return isAnyEdited ? speeds : std::vector<float>{};
}

void ImportDialog::refresh()
{
    const auto asset = model::importTemplate(m_path.toStdString(), settings());
    if (!asset) {
        m_height->setText(QString::fromStdString(asset.error().message));
        return;
    }
    m_height->setText(
        tr("%1 m").arg(QLocale().toString(static_cast<double>(asset.value()->height), 'f', 2)));
    for (int row = 0; row < m_clips->rowCount(); ++row) {
        auto* box = static_cast<QDoubleSpinBox*>(m_clips->cellWidget(row, 2));
        const bool wasEdited =
            box->property("fromFile").isValid() &&
            std::abs(box->value() - box->property("fromFile").toDouble()) > 0.001;
        const double speed =
            static_cast<double>(asset.value()->clips[static_cast<std::size_t>(row)].speed);
        if (!wasEdited) {
            box->setValue(speed);
        }
        // As the box shows it, rounded, so that an untouched box does not count as edited.
        box->setProperty("fromFile", wasEdited ? QVariant(speed) : QVariant(box->value()));
    }
    m_preview->show(asset.value(), std::max(m_clips->currentRow(), 0));
}

} // namespace crowd::widgets
