// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "behavior/motion/GaitTable.h"
#include "model/scene/Scene.h"

namespace crowd::behavior {

/// What a session knows of each template of the scene, by its index in the scene's list. An index
/// beyond the end stands for a template that is not there. Written when the scene is read; any
/// number of threads may read in between.
class TemplateTables
{
public:
    using Entries = std::vector<model::TemplateEntry>;
    struct ClipFacts
    {
        float seconds = 0.0F; ///< 0: a pose
        bool isLooped = true;
        bool isMover = false; ///< moves people over the ground
    };

    void read(const Entries& entries);
    [[nodiscard]] const std::shared_ptr<const Entries>& entries() const { return m_entries; }
    /// The number of templates where none has the id.
    [[nodiscard]] std::uint32_t indexOf(model::TemplateId id) const;
    [[nodiscard]] bool has(std::uint32_t table) const { return table < m_facts.size(); }
    /// Null: there is no such template.
    [[nodiscard]] const model::TemplateEntry* entry(std::uint32_t table) const
    {
        return has(table) ? &(*m_entries)[table] : nullptr;
    }
    /// Null: people of that template have nothing to walk with.
    [[nodiscard]] const GaitTable* gaits(std::uint32_t table) const
    {
        return has(table) && !m_facts[table].gaits.isEmpty() ? &m_facts[table].gaits : nullptr;
    }
    /// `clip` as the clip column counts; null: there is no such clip.
    [[nodiscard]] const ClipFacts* clip(std::uint32_t table, int clip) const;
    /// As the clip column counts; -1: there is none of that name.
    [[nodiscard]] int clipNamed(std::uint32_t table, std::string_view name) const;
    /// A person's where there is no such template. Metres at girth 1.
    [[nodiscard]] const model::Footprint& footprint(std::uint32_t table) const;
    /// m/s at height 1.
    [[nodiscard]] float usualSpeed(std::uint32_t table) const;
    /// Gait for a value of the walk style's column; 0: the one that fits the speed.
    [[nodiscard]] std::uint32_t gaitOfStyle(std::uint32_t table, std::uint16_t walkStyle) const;

private:
    struct Facts
    {
        GaitTable gaits;
        std::vector<ClipFacts> clips; ///< as the clip column counts
        model::Footprint footprint;
        float usualSpeed = model::kUsualWalkingSpeed;
    };

    std::shared_ptr<const Entries> m_entries = std::make_shared<const Entries>();
    std::vector<Facts> m_facts; ///< one per entry
};

} // namespace crowd::behavior
