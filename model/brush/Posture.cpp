// SPDX-License-Identifier: MIT
#include "model/brush/Posture.h"

#include "model/brush/ClipChoice.h"
#include "model/brush/Operator.h"

namespace crowd::model {

void sitDown(const TemplateEntry* entry, IndividualRows& rows, std::size_t row,
             const WorldSeat& seat)
{
    std::uint16_t& clip = rows.column(columns::clip)[row];
    if (entry != nullptr && isRest(*entry, clip, false)) {
        clip = usualClip(*entry, true);
    }
    rows.column(columns::seat)[row] = seat.id;
    rows.column(columns::position)[row] = seat.seat.position;
    rows.column(columns::heading)[row] = wrappedAngle(seat.seat.headingRadians);
}

void standUp(const TemplateEntry* entry, IndividualRows& rows, std::size_t row)
{
    SeatId& seat = rows.column(columns::seat)[row];
    std::uint16_t& clip = rows.column(columns::clip)[row];
    if (entry != nullptr && seat != kNoSeat && isRest(*entry, clip, true)) {
        clip = usualClip(*entry, false);
    }
    seat = kNoSeat;
}

} // namespace crowd::model
