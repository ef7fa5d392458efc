#pragma once

#include "lepp/geometry/pslg.hpp"

namespace lepp::test {

/// Writes `pslg` as a .poly file with numbers from 0 and the tags of curves as markers, by system
/// calls and stack memory alone, so that a signal handler may call it.
/// \return false if the file could not be written
bool save_case(const Pslg& pslg, const char* path) noexcept;

}  // namespace lepp::test
