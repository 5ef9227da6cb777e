// SPDX-License-Identifier: MIT
#include "app/window/MovieDialog.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QSettings>
#include <QtCore/QSignalBlocker>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

#include "app/pictures/MovieFormats.h"
#include "app/window/PassFields.h"
#include "app/window/PictureSizeFields.h"
#include "widgets/forms/NumberBox.h"

namespace crowd::app {

namespace {

const QString kMovieRate = QStringLiteral("movie/framesPerSecond");
const QString kMovieSeconds = QStringLiteral("movie/seconds");
const QString kMovieTransparent = QStringLiteral("movie/transparent");
constexpr double kRates[] = {24.0, 25.0, 30.0, 50.0, 60.0};
constexpr double kUsualRate = 30.0;
constexpr double kUsualSeconds = 10.0;
constexpr double kMostSeconds = 36000.0;
constexpr int kMovieStep = 2; ///< pixels: encoders want even numbers of rows and columns

QDoubleSpinBox* secondsField(const char* name, QWidget* parent)
{
    auto* box = new widgets::NumberBox(parent);
    box->setObjectName(QLatin1String(name));
    box->setRange(0.0, kMostSeconds);
    box->setDecimals(2);
    box->setSuffix(MovieDialog::tr(" s"));
    return box;
}

} // namespace

int TimeSpan::pictures(double framesPerSecond) const
{
    return std::max(1, static_cast<int>(std::floor((to - from) * framesPerSecond + 1e-6)));
}

MovieDialog::MovieDialog(const Offer& offer, QWidget* parent)
    : QDialog(parent), m_offer(offer), m_sources(new QComboBox(this)),
      m_from(secondsField("movieFrom", this)), m_to(secondsField("movieTo", this)),
      m_rates(new QComboBox(this)), m_count(new QLabel(this)),
      m_size(new PictureSizeFields(offer.view, kMostMoviePixelsASide, kMovieStep,
                                   QStringLiteral("movie/size"), this)),
      m_cameras(new QComboBox(this)),
      m_passes(new PassFields(QStringLiteral("movie/passes"), this)),
      m_transparent(new QCheckBox(tr("Transparent background"), this))
{
    setWindowTitle(tr("Make Movie"));
    addCameras();
    m_count->setObjectName(QStringLiteral("movieCount"));
    m_count->setEnabled(false);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->addButton(tr("Make…"), QDialogButtonBox::AcceptRole)->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &MovieDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &MovieDialog::reject);
    auto* form = new QFormLayout(this);
    addSource(*form);
    addRate(*form);
    form->addRow(tr("Camera"), m_cameras);
    form->addRow(tr("Size"), m_size);
    form->addRow(tr("Passes"), m_passes);
    m_transparent->setObjectName(QStringLiteral("movieTransparent"));
    m_transparent->setToolTip(tr("For numbered pictures that are put over others"));
    m_transparent->setChecked(QSettings().value(kMovieTransparent).toBool());
    form->addRow(QString(), m_transparent);
    form->addRow(buttons);
    for (QDoubleSpinBox* box : {m_from, m_to}) {
        connect(box, &QDoubleSpinBox::valueChanged, this, &MovieDialog::countPictures);
    }
    connect(m_rates, &QComboBox::currentIndexChanged, this, &MovieDialog::countPictures);
    connect(m_sources, &QComboBox::currentIndexChanged, this, &MovieDialog::chooseSource);
    chooseSource();
}

void MovieDialog::addSource(QFormLayout& form)
{
    m_sources->setObjectName(QStringLiteral("movieSources"));
    if (m_offer.run) {
        m_sources->addItem(tr("What has been played"), true);
    }
    m_sources->addItem(tr("The scene as it plays by itself"), false);
    m_sources->setToolTip(tr("What has been played, with all that was sent, called and recalled "
                             "meanwhile; or the scene as it plays if nobody touches it"));
    auto* times = new QHBoxLayout;
    times->addWidget(m_from);
    times->addWidget(new QLabel(tr("to"), this));
    times->addWidget(m_to);
    times->addStretch(1);
    form.addRow(tr("Of"), m_sources);
    form.addRow(tr("From"), times);
}

void MovieDialog::addCameras()
{
    using Kind = MovieCamera::Kind;
    m_cameras->setObjectName(QStringLiteral("movieCameras"));
    const auto add = [this](const QString& text, Kind kind) {
        m_cameras->addItem(text, static_cast<int>(kind));
    };
    if (m_offer.hasMoves) {
        add(tr("As the timeline moves it"), Kind::Timeline);
    }
    add(tr("The view as it is"), Kind::View);
    add(tr("Once around what the view looks at"), Kind::Turntable);
    for (const QString& camera : m_offer.cameras) {
        add(camera, Kind::Scene);
    }
}

void MovieDialog::addRate(QFormLayout& form)
{
    m_rates->setObjectName(QStringLiteral("movieRates"));
    const double last = QSettings().value(kMovieRate, kUsualRate).toDouble();
    for (const double rate : kRates) {
        m_rates->addItem(tr("%1 pictures a second").arg(rate), rate);
        if (rate == last) {
            m_rates->setCurrentIndex(m_rates->count() - 1);
        }
    }
    auto* row = new QHBoxLayout;
    row->addWidget(m_rates);
    row->addWidget(m_count);
    row->addStretch(1);
    form.addRow(tr("Rate"), row);
}

void MovieDialog::chooseSource()
{
    const double seconds = QSettings().value(kMovieSeconds, kUsualSeconds).toDouble();
    const double least = isOfRun() ? m_offer.run->from : 0.0;
    const double most = isOfRun() ? m_offer.run->to : kMostSeconds;
    TimeSpan offered =
        isOfRun() ? *m_offer.run : TimeSpan{0.0, std::max(seconds, m_offer.lastMark)};
    if (m_offer.range && m_offer.range->from < most && m_offer.range->to > least) {
        offered = {std::max(least, m_offer.range->from), std::min(most, m_offer.range->to)};
    }
    for (QDoubleSpinBox* box : {m_from, m_to}) {
        const QSignalBlocker blocker(box);
        box->setRange(least, most);
        box->setValue(box == m_from ? offered.from : offered.to);
    }
    countPictures();
}

void MovieDialog::countPictures()
{
    const TimeSpan span = this->span();
    m_count->setText(tr("%n picture(s)", nullptr, span.pictures(framesPerSecond())));
}

bool MovieDialog::isOfRun() const
{
    return m_sources->currentData().toBool();
}

/// From the earlier to the later, whichever field says it.
TimeSpan MovieDialog::span() const
{
    return {std::min(m_from->value(), m_to->value()), std::max(m_from->value(), m_to->value())};
}

double MovieDialog::framesPerSecond() const
{
    return m_rates->currentData().toDouble();
}

glm::ivec2 MovieDialog::chosenSize() const
{
    return m_size->chosen();
}

PicturePasses MovieDialog::passes() const
{
    return m_passes->chosen();
}

bool MovieDialog::isTransparent() const
{
    return m_transparent->isChecked();
}

MovieCamera MovieDialog::camera() const
{
    const int before = m_cameras->count() - static_cast<int>(m_offer.cameras.size());
    return {static_cast<MovieCamera::Kind>(m_cameras->currentData().toInt()),
            m_cameras->currentIndex() - before};
}

void MovieDialog::accept()
{
    QSettings settings;
    settings.setValue(kMovieRate, framesPerSecond());
    if (!isOfRun()) {
        settings.setValue(kMovieSeconds, span().to);
    }
    m_size->remember();
    m_passes->remember();
    settings.setValue(kMovieTransparent, isTransparent());
    QDialog::accept();
}

} // namespace crowd::app
