// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/scene/contact_law.h>

namespace softgrain
{
namespace
{
class Coulomb final : public ContactLaw
{
};

[[maybe_unused]] const bool registered =
    Registry<ContactLaw>::instance().add("coulomb",
                                         "contacts push, and resist sliding by up to friction times force",
                                         [] { return std::make_unique<Coulomb>(); });
} // namespace
} // namespace softgrain
