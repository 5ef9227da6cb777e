// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtWidgets/QWidget>

#include "model/scene/Scene.h"

class QHBoxLayout;
class QVBoxLayout;

/// Small fields that a sentence is built from; each calls back when the artist changed it.
namespace crowd::widgets {

void addChoiceField(QHBoxLayout* row, const QStringList& names, int index,
                    const std::function<void(int)>& changed);
/// The same in groups of indices with lines between them.
void addGroupedField(QHBoxLayout* row, const QStringList& names,
                     const std::vector<std::vector<int>>& groups, int index,
                     const std::function<void(int)>& changed);
/// `zero`: what it says at the lowest value, where that means something else.
void addNumberField(QHBoxLayout* row, double value, double low, double high, const QString& suffix,
                    const std::function<void(double)>& changed, const QString& zero = {});
/// A whole number from 0 on.
void addCountField(QHBoxLayout* row, std::uint32_t value, std::uint32_t most, const QString& suffix,
                   const std::function<void(std::uint32_t)>& changed, const QString& zero);
void addTextField(QHBoxLayout* row, const QString& text, const QString& placeholder,
                  const std::function<void(const QString&)>& changed);
/// Places, paths, templates or an artist's numbers of the scene, with "any" for 0 where that is
/// allowed.
void addReferenceField(QHBoxLayout* row, const model::Scene& scene, model::FieldRole role,
                       std::uint32_t id, const QString& any,
                       const std::function<void(std::uint32_t)>& changed);
void addTagField(QHBoxLayout* row, const model::Scene& scene, std::uint8_t tag,
                 const std::function<void(std::uint8_t)>& changed);
/// Clips of the scene's templates, ticked in a menu.
void addClipField(QHBoxLayout* row, const model::Scene& scene,
                  const std::vector<model::ClipWeight>& clips,
                  const std::function<void(const std::vector<model::ClipWeight>&)>& changed);
/// How often each of several clips comes, one row each.
void addClipWeights(QVBoxLayout* layout, const std::vector<model::ClipWeight>& clips,
                    const std::function<void(const std::vector<model::ClipWeight>&)>& changed);
/// One clip of the scene's templates by name.
void addOneClipField(QHBoxLayout* row, const model::Scene& scene, const std::string& clip,
                     const std::function<void(const std::string&)>& changed);
/// Slots of the scene's templates by name, and all of them.
void addSlotField(QHBoxLayout* row, const model::Scene& scene, const std::string& slot,
                  const std::function<void(const std::string&)>& changed);
void addColorField(QHBoxLayout* row, const model::PaintColor& color, const QString& tip,
                   const std::function<void(const model::PaintColor&)>& changed);
/// Of the buttons beside a field, logical pixels.
inline constexpr int kSmallButton = 20;
void addRemoveButton(QHBoxLayout* row, const QString& tip, const std::function<void()>& pressed);

} // namespace crowd::widgets
