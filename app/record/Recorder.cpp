// SPDX-License-Identifier: MIT
#include "app/record/Recorder.h"

#include <algorithm>

#include <QtCore/QDir>
#include <QtCore/QFileInfo>

#include "app/record/DeltaScript.h"
#include "app/record/ScriptText.h"
#include "model/project/ProjectFile.h"
#include "model/project/ProjectWriter.h"
#include "model/project/WholeFile.h"

namespace crowd::app {

using namespace model;

namespace {

/// Whatever language the editor speaks, scripts are in English.
constexpr const char* kHead =
    R"(# Recorded in Crowdbrush. Runs in the console of the editor, on the open scene, or without a window:
#     crowdbrush script FILE.py [WHERE-TO-SAVE.crowd]
)";
constexpr const char* kFoot = R"(
if len(sys.argv) > 1:
    scene.save(sys.argv[1])
)";
constexpr const char* kNotExact = "# A stroke that went by where characters were while it played, "
                                  "or gave back what they had: what came of it.\n";

std::string openingOf(const QString& startName, const QString& startPath, bool isEmpty)
{
    if (isEmpty) {
        return "crowdbrush.Scene()";
    }
    if (!startName.isEmpty()) {
        return "crowdbrush.open(pathlib.Path(__file__).with_name(" +
               pythonText(startName.toStdString()) + "))";
    }
    return startPath.isEmpty() ? "crowdbrush.open(\"SCENE.crowd\")  # the scene as it was"
                               : "crowdbrush.open(" + pythonText(startPath.toStdString()) + ')';
}

} // namespace

Recorder::Recorder(SceneDocument& document, QObject* parent) : QObject(parent), m_document(document)
{
    connect(&document, &SceneDocument::stepCommitted, this, &Recorder::commit);
    connect(&document, &SceneDocument::stepTaken, this, &Recorder::takeStep);
    connect(&document, &SceneDocument::changed, this, &Recorder::followScene);
}

Recorder::~Recorder() = default;

void Recorder::setRecording(bool isOn)
{
    if (m_isRecording == isOn) {
        return;
    }
    m_isRecording = isOn;
    m_left.reset();
    if (isOn) {
        m_index = m_document.undoStack().index();
        begin();
    }
    Q_EMIT recordingChanged(isOn);
}

void Recorder::begin()
{
    m_script = {std::make_unique<const Scene>(m_document.scene()),
                m_document.path(),
                {},
                {},
                m_index,
                m_index};
    Q_EMIT started();
}

void Recorder::add(std::string text)
{
    m_script.steps.push_back(std::move(text));
    Q_EMIT added(QString::fromStdString(m_script.steps.back()));
}

void Recorder::commit(const StepCommitted& step)
{
    if (!m_isRecording) {
        return;
    }
    m_left.reset();
    m_index = m_document.undoStack().index() + 1;
    m_script.end = m_index;
    if (step.stroke != nullptr && step.stroke->settings.kind() != BrushKind::Script) {
        addStroke(step);
    } else {
        add(deltaScript(*step.delta, step.text, m_document.scene()));
    }
}

void Recorder::addStroke(const StepCommitted& step)
{
    const RecordedStroke& stroke = *step.stroke;
    if (stroke.isExact || (m_proof && m_proof(step))) {
        add(m_script.strokes.write(stroke, m_document.scene()));
        return;
    }
    add(kNotExact + deltaScript(*step.delta, step.text, m_document.scene()));
    const QString remark = tr("Recorded as what came of it, not as a stroke: %1.").arg(step.text);
    QMetaObject::invokeMethod( // the status bar says first what the stroke did
        this, [this, remark] { Q_EMIT remarked(remark); }, Qt::QueuedConnection);
}

void Recorder::takeStep(bool isUndo)
{
    if (!m_isRecording) {
        return;
    }
    const int before = m_index;
    m_index += isUndo ? -1 : 1;
    const int step = std::min(before, m_index);
    if (step >= m_script.first && step < m_script.end) {
        add(isUndo ? "scene.undo()\n" : "scene.redo()\n");
        return;
    }
    if (!m_script.steps.empty()) {
        m_left = LeftScript{std::move(m_script), before};
    }
    if (m_left && m_left->index == m_index) {
        bringBack();
        return;
    }
    // A script cannot take back what it did not do: it starts from what is there now.
    begin();
    Q_EMIT remarked(tr("The recording starts anew: this step was done before it began."));
}

/// The scene is again as it was when that script was left.
void Recorder::bringBack()
{
    m_script = std::move(m_left->script);
    m_left.reset();
    Q_EMIT started();
    for (const std::string& step : m_script.steps) {
        Q_EMIT added(QString::fromStdString(step));
    }
}

void Recorder::followScene(const SceneChange& change)
{
    if (m_isRecording && std::holds_alternative<SceneReplaced>(change)) {
        setRecording(false);
        Q_EMIT remarked(tr("The recording ended: another scene is open now."));
    }
}

bool Recorder::startsEmpty() const
{
    const auto text = projectToText(*m_script.start);
    const auto empty = projectToText(Scene());
    return text && empty && text.value() == empty.value();
}

std::string Recorder::script(const QString& startName) const
{
    if (!m_script.start) {
        return {};
    }
    std::string text = std::string(kHead) + "import pathlib\nimport sys\n\nimport crowdbrush\n\n" +
                       "if \"scene\" not in globals():\n    scene = " +
                       openingOf(startName, m_script.startPath, startsEmpty()) + "\n\n";
    for (const std::string& step : m_script.steps) {
        text += step;
    }
    return text + kFoot;
}

Result<void> Recorder::save(const QString& path) const
{
    const QFileInfo file(path);
    const QString start = file.completeBaseName() + QStringLiteral("-start.crowd");
    const std::string text = script(start);
    if (m_script.start && !startsEmpty()) {
        if (auto saved = saveProject(*m_script.start, file.dir().filePath(start)); !saved) {
            return saved;
        }
    }
    if (auto saved = writeWholeFile(path, text); !saved) {
        return Error{QT_TRANSLATE_NOOP("Messages",
                                       "%1: could not be written (%2). The script was not "
                                       "saved; choose another place or free some room."),
                     path.toStdString(), saved.error().said};
    }
    return {};
}

} // namespace crowd::app
