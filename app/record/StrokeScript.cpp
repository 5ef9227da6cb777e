// SPDX-License-Identifier: MIT
#include "app/record/StrokeScript.h"

#include <set>

#include "app/python/BrushRules.h"
#include "app/record/FieldScript.h"
#include "app/record/ScriptText.h"

namespace crowd::app {

using namespace model;

namespace {

/// Of the script: "colour_brush".
std::string variableOf(BrushKind kind)
{
    return std::string(brushType(kind).info.id) + "_brush";
}

std::string points(const std::vector<PointerInput>& inputs)
{
    std::vector<std::string> rows;
    for (const PointerInput& each : inputs) {
        const glm::dvec2 at = each.pixels();
        rows.push_back('(' + pythonText(at.x) + ", " + pythonText(at.y) + ", " +
                       pythonText(each.pressure) + ", " + pythonText(each.timeSeconds) + ", " +
                       pythonText(each.shownSeconds) + ')');
    }
    return pythonList(rows, 0);
}

/// ", selected={3: [7, 9]}": by number of the dab, and each of them once where the stroke changes
/// nobody twice. Empty where it finds them itself.
std::string selected(const RecordedStroke& stroke)
{
    if (stroke.isExact) {
        return {};
    }
    std::set<IndividualId> met;
    std::vector<std::string> dabs;
    for (std::size_t dab = 0; dab < stroke.selected.size(); ++dab) {
        std::vector<IndividualId> ids = stroke.selected[dab];
        if (!stroke.settings.buildUp) {
            std::erase_if(ids, [&met](IndividualId id) { return !met.insert(id).second; });
        }
        if (!ids.empty()) {
            dabs.push_back(pythonText(dab) + ": " + pythonIds(ids, kIndent));
        }
    }
    return ", selected=" + pythonList(dabs, 0, '{', '}');
}

} // namespace

std::string StrokeScript::brush(const BrushSettings& settings)
{
    const BrushType& type = brushType(settings.kind());
    const std::string variable = variableOf(settings.kind());
    std::string text;
    const auto known = m_said.find(settings.kind());
    BrushSettings was(settings.kind());
    if (known == m_said.end()) {
        text =
            variable + " = crowdbrush.Brush(crowdbrush.BrushKind." + type.info.scriptKind + ")\n";
        // Said whatever it is: it is what brushes of scripts and of the window begin with
        // differently.
        if (auto* create = was.find<CreateSettings>()) {
            create->anywhere = !settings.as<CreateSettings>().anywhere;
        }
    } else {
        was = known->second;
    }
    const std::string section = type.info.scriptName;
    text += fieldChanges(fieldsOf<BrushSettings>(), &was, &settings, variable);
    text += fieldChanges(type.fields, type.settings(was), type.settings(settings),
                         section.empty() ? variable : variable + '.' + section);
    m_said[settings.kind()] = settings;
    return text;
}

std::string StrokeScript::write(const RecordedStroke& stroke, const Scene& scene)
{
    std::string text = brush(stroke.settings);
    if (m_camera != stroke.camera) {
        m_camera = stroke.camera;
        text += "view = " + pythonText(stroke.camera) + '\n';
    }
    return text + "scene.stroke(" + variableOf(stroke.settings.kind()) + ", " +
           points(stroke.inputs) + ", camera=view, size=(" + pythonText(stroke.viewSize.x) + ", " +
           pythonText(stroke.viewSize.y) + "), seed=" + pythonText(stroke.seed) + selected(stroke) +
           (checkReferences(scene, stroke.settings) ? ")\n" : ", allow_missing=True)\n");
}

} // namespace crowd::app
