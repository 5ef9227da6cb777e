// SPDX-License-Identifier: MIT
#include "widgets/dialogs/WelcomePage.h"

#include <QtCore/QDir>
#include <QtCore/QEvent>
#include <QtCore/QFileInfo>
#include <QtCore/QTimer>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr QSize kPicture{272, 153};
constexpr int kColumns = 2;
constexpr int kMostRecent = 6;
constexpr int kStartsWidth = 210;
constexpr int kIconSize = 20;
constexpr double kTitleScale = 1.5;

/// The frame says where the keyboard is; the colours are the palette's, so light and dark follow.
const QString kStyle = QStringLiteral(R"(
QToolButton { border: 2px solid transparent; border-radius: 6px; padding: 4px; }
QToolButton:hover { background: palette(midlight); }
QToolButton:focus { border-color: palette(highlight); }
QPushButton[isStart="true"] { text-align: left; padding: 6px 8px; }
)");

QLabel* makeHeading(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    return label;
}

/// "theatre" is the theatre in the artist's language; a scene that somebody added keeps its name.
QString shownName(const QString& path)
{
    QString name = QFileInfo(path).completeBaseName().replace(QLatin1Char('_'), QLatin1Char(' '));
    if (name == QLatin1String("theatre")) {
        return WelcomePage::tr("Theatre");
    }
    if (name == QLatin1String("city")) {
        return WelcomePage::tr("City");
    }
    if (name == QLatin1String("stadium")) {
        return WelcomePage::tr("Stadium");
    }
    if (name == QLatin1String("meadow")) {
        return WelcomePage::tr("Meadow");
    }
    name[0] = name[0].toUpper();
    return name;
}

QIcon pictureOf(const QString& path)
{
    const QFileInfo scene(path);
    const QPixmap picture(scene.dir().filePath(scene.completeBaseName() + QStringLiteral(".png")));
    return picture.isNull() ? iconNamed("stage") : QIcon(picture);
}

/// Holds back the next press of a mouse button, wherever in the program, for as long as it may be
/// the second of a double click. Deletes itself.
class SecondClick : public QObject
{
public:
    explicit SecondClick(QObject* parent) : QObject(parent)
    {
        qApp->installEventFilter(this);
        QTimer::singleShot(QApplication::doubleClickInterval(), this, &QObject::deleteLater);
    }

protected:
    bool eventFilter(QObject*, QEvent* event) override
    {
        return event->type() == QEvent::MouseButtonPress ||
               event->type() == QEvent::MouseButtonDblClick;
    }
};

} // namespace

WelcomePage::WelcomePage(const WelcomeOffer& offer, QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("welcomePage"));
    setWindowTitle(tr("Welcome"));
    setStyleSheet(kStyle);
    auto* title = new QLabel(tr("Paint a crowd"), this);
    QFont font = title->font();
    font.setPointSizeF(font.pointSizeF() * kTitleScale);
    title->setFont(font);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(22);
    columns->addLayout(makeExamples(offer.examples), 1);
    columns->addLayout(makeStarts(offer.recent));
    auto* atStart = new QCheckBox(tr("&Show this page at start"), this);
    atStart->setObjectName(QStringLiteral("showAtStart"));
    atStart->setChecked(offer.isShownAtStart);
    connect(atStart, &QCheckBox::toggled, this, &WelcomePage::showAtStartChanged);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &WelcomePage::reject);
    auto* foot = new QHBoxLayout;
    foot->addWidget(atStart, 1);
    foot->addWidget(buttons);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(20, 16, 20, 14);
    layout->setSpacing(12);
    layout->addWidget(title);
    layout->addLayout(columns, 1);
    layout->addLayout(foot);
    layout->setSizeConstraint(QLayout::SetFixedSize);
}

void WelcomePage::accept()
{
    new SecondClick(qApp);
    QDialog::accept();
}

template<class Signal>
void WelcomePage::closeThen(Signal signal)
{
    accept();
    (this->*signal)();
}

void WelcomePage::choose(const QString& path)
{
    accept();
    Q_EMIT sceneChosen(path);
}

QBoxLayout* WelcomePage::makeExamples(const QStringList& examples)
{
    auto* layout = new QVBoxLayout;
    layout->addWidget(makeHeading(tr("Ready-made scenes"), this));
    auto* grid = new QGridLayout;
    grid->setSpacing(6);
    int count = 0;
    for (const QString& path : examples) {
        grid->addWidget(makeExample(path), count / kColumns, count % kColumns);
        ++count;
    }
    layout->addLayout(grid);
    layout->addStretch();
    return layout;
}

QWidget* WelcomePage::makeExample(const QString& path)
{
    auto* button = new QToolButton(this);
    button->setObjectName(QFileInfo(path).completeBaseName());
    button->setText(shownName(path));
    button->setIcon(pictureOf(path));
    button->setIconSize(kPicture);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setToolTip(tr("Open “%1” as a new scene").arg(button->text()));
    connect(button, &QToolButton::clicked, this, [this, path] { choose(path); });
    return button;
}

QBoxLayout* WelcomePage::makeStarts(const QStringList& recent)
{
    auto* layout = new QVBoxLayout;
    layout->addWidget(makeHeading(tr("Start"), this));
    QPushButton* theatre = makeStart("new-theatre", tr("New Empty &Theatre"), "newTheatre");
    QPushButton* ground = makeStart("new", tr("New Empty &Ground"), "newGround");
    QPushButton* open = makeStart("open", tr("&Open…"), "open");
    connect(theatre, &QPushButton::clicked, this,
            [this] { closeThen(&WelcomePage::newTheatreChosen); });
    connect(ground, &QPushButton::clicked, this,
            [this] { closeThen(&WelcomePage::newGroundChosen); });
    connect(open, &QPushButton::clicked, this, [this] { closeThen(&WelcomePage::openChosen); });
    QPushButton* library = makeStart("add", tr("Character &Library…"), "library");
    library->setToolTip(tr("Choose whom to paint with in the scene behind this page"));
    connect(library, &QPushButton::clicked, this,
            [this] { closeThen(&WelcomePage::libraryChosen); });
    for (QPushButton* button : {theatre, ground, open, library}) {
        layout->addWidget(button);
    }
    layout->addSpacing(10);
    layout->addWidget(makeHeading(tr("Recent"), this));
    for (const QString& path : recent.mid(0, kMostRecent)) {
        const QString name = fontMetrics().elidedText(QFileInfo(path).fileName(), Qt::ElideMiddle,
                                                      kStartsWidth - 2 * kIconSize);
        QPushButton* button = makeStart(
            "recent", QString(name).replace(QLatin1Char('&'), QStringLiteral("&&")), "recent");
        button->setToolTip(QDir::toNativeSeparators(path));
        connect(button, &QPushButton::clicked, this, [this, path] { choose(path); });
        layout->addWidget(button);
    }
    if (recent.isEmpty()) {
        auto* none = new QLabel(tr("No scenes yet"), this);
        none->setEnabled(false);
        layout->addWidget(none);
    }
    layout->addStretch();
    return layout;
}

QPushButton* WelcomePage::makeStart(const char* icon, const QString& text, const char* name)
{
    auto* button = new QPushButton(iconNamed(icon), text, this);
    button->setObjectName(QLatin1String(name));
    button->setProperty("isStart", true);
    button->setIconSize({kIconSize, kIconSize});
    button->setFixedWidth(kStartsWidth);
    button->setAutoDefault(false); // Return belongs to what has the keyboard
    return button;
}

} // namespace crowd::widgets
