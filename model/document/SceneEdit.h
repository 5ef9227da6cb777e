// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <QtCore/QString>

#include "model/document/SceneDocument.h"
#include "model/scene/SceneMembers.h"

namespace crowd::model {

class EditRecord;
struct ChangeOver;

/// A transaction on the document: every change is applied (and announced) at once, old values are
/// kept at first touch. commit() pushes exactly one undo command holding ids with old and new
/// values (columns, not whole individuals), already applied; or none when nothing changed in the
/// end. rollback(), or destruction without commit, puts everything back, the next id included.
class SceneEdit
{
public:
    ~SceneEdit();
    SceneEdit(const SceneEdit&) = delete;
    SceneEdit& operator=(const SceneEdit&) = delete;

    [[nodiscard]] const Scene& scene() const;
    [[nodiscard]] const EarlierPeople& earlierPeople() const;

    /// Adds rows with fresh ids (rows.ids are overwritten by ascending new ones, which are
    /// returned).
    std::vector<IndividualId> addIndividuals(IndividualRows rows);
    void removeIndividuals(std::span<const IndividualId> ids); ///< ascending, all present
    /// bytes: one value each, or one for all. Ids ascending, all present.
    void setColumn(ColumnId column, std::span<const IndividualId> ids,
                   std::span<const std::byte> bytes);
    template<class T>
    void setColumn(ColumnKey<T> key, std::span<const IndividualId> ids, std::span<const T> values)
    {
        setColumn(key.id, ids, std::as_bytes(values));
    }

    // Scene-level edits; ids of entries without id (0) are given out here, 0 when none is left.
    TemplateId addTemplate(TemplateEntry entry);
    void removeTemplate(TemplateId id);              ///< no individual uses it
    void changeTemplate(const TemplateEntry& entry); ///< by id
    std::uint8_t addStage(StageEntry entry);
    void removeStage(std::uint8_t id);
    void changeStage(const StageEntry& entry);
    /// A member of the scene that is kept as a whole, see SceneMembers.
    template<class M>
    requires(M::kind == MemberKind::Value) void set(typename M::Type value);
    void setCameras(std::vector<NamedCamera> all) { set<members::Cameras>(std::move(all)); }
    void setLighting(const Lighting& lighting) { set<members::Light>(lighting); }
    /// By ascending ids.
    void setLights(Lights lights) { set<members::Lights>(std::move(lights)); }
    void setLooks(Looks looks) { set<members::Looks>(std::move(looks)); }
    void setRules(std::vector<Rule> rules) { set<members::Rules>(std::move(rules)); }
    void setTags(std::vector<TagName> tags) { set<members::Tags>(std::move(tags)); }
    /// By ascending ids.
    void setNumbers(std::vector<NumberName> all) { set<members::Numbers>(std::move(all)); }
    void setCues(std::vector<Cue> cues) { set<members::Cues>(std::move(cues)); }
    /// In the order in which they are shown; with different ids.
    void setStates(std::vector<State> states) { set<members::States>(std::move(states)); }
    /// By ascending ids.
    void setFeatures(std::vector<FeatureKind> kinds) { set<members::Features>(std::move(kinds)); }
    /// By ascending ids. Those of kinds that are gone go too; those of one that has become mutual
    /// are one of each two.
    void setRelationKinds(std::vector<RelationKind> kinds);
    /// Relations between people of the scene, of its kinds: adds them or sets their strength.
    void relate(std::span<const Relation> relations);
    /// Takes those away that there are.
    void unrelate(std::span<const Relation> relations);
    void setSurface(const SurfaceSettings& surface) { set<members::Surface>(surface); }
    /// One of kStepRates.
    void setStepsPerSecond(std::uint32_t steps) { set<members::Steps>(steps); }
    PlaceId addPlace(Place place);
    void changePlace(const Place& place); ///< by id
    /// Also takes it out of all paths.
    void removePlace(PlaceId id);
    PathId addPath(Path path);
    void changePath(const Path& path); ///< by id; its places are there
    /// Its places stay; nobody follows it any more.
    void removePath(PathId id);
    /// All places and paths at once, by ascending id; paths name only what is among them. Who
    /// followed a path that is gone follows none.
    void setPlacesAndPaths(std::vector<Place> places, std::vector<Path> paths);

    /// By ascending ids.
    void setGroups(std::vector<Group> groups) { set<members::Groups>(std::move(groups)); }

    /// Before people change in these columns: see SceneDocument::changingOver().
    void announce(const ChangeOver& change);

    /// Undoes what was done so far and stays open (gradients are re-evaluated this way).
    void rollback();
    /// Ends the edit as one undo step with this text; false when nothing changed. `stroke`: what
    /// made it, for those who record.
    bool commit(const QString& undoText, const RecordedStroke* stroke = nullptr);

private:
    friend class SceneDocument;
    explicit SceneEdit(SceneDocument& document);
    void forgetRelations(std::span<const IndividualId> ids);
    void changeRelations(std::span<const Relation> relations, bool isGone);

    SceneDocument& m_document;
    std::unique_ptr<EditRecord> m_record;
};

} // namespace crowd::model
