// SPDX-License-Identifier: MIT
#include "model/project/JsonEntries.h"

#include <numeric>

namespace crowd::model {

Message idProblem(const char* key, std::uint32_t id)
{
    return id == 0
               ? Message(QT_TRANSLATE_NOOP("Messages", "%1: the id %2 is not allowed"), key, id)
               : Message(QT_TRANSLATE_NOOP("Messages", "%1: the id %2 is given twice"), key, id);
}

std::vector<std::size_t> orderOfIds(const std::vector<std::uint32_t>& ids, const char* key,
                                    Message& problem)
{
    std::vector<std::size_t> order(ids.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&ids](std::size_t index) { return ids[index]; });
    for (std::size_t i = 0; i < order.size() && problem.empty(); ++i) {
        const std::uint32_t id = ids[order[i]];
        if (id == 0 || (i > 0 && ids[order[i - 1]] == id)) {
            problem = idProblem(key, id);
        }
    }
    return order;
}

} // namespace crowd::model
