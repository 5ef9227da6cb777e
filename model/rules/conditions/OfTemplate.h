// SPDX-License-Identifier: MIT
#pragma once

#include "model/rules/RuleFields.h"

namespace crowd::model::conditions {

struct OfTemplate
{
    static constexpr KindText kText{.key = "template",
                                    .name = QT_TRANSLATE_NOOP("Rules", "of template"),
                                    .doc = "Is made from a template.",
                                    .yes = QT_TRANSLATE_NOOP("Rules", "is"),
                                    .no = QT_TRANSLATE_NOOP("Rules", "is not"),
                                    .alone = QT_TRANSLATE_NOOP("Rules", "is of a template")};

    TemplateId templateId = 0;

    static constexpr auto fields()
    {
        return std::tuple(
            field(&OfTemplate::templateId,
                  rulefields::reference({.doc = "its id"}, "template", FieldRole::Template)));
    }
    static constexpr auto sentences()
    {
        return std::array{Sentence<OfTemplate>{QT_TRANSLATE_NOOP("Rules", "a {template}"), nullptr,
                                               QT_TRANSLATE_NOOP("Rules", "not a {template}")}};
    }
    friend bool operator==(const OfTemplate&, const OfTemplate&) = default;
};

} // namespace crowd::model::conditions
