#pragma once
/// @file
/// A verdict on its way from the process that has judged to the one that has asked for it.

#include <string>

#include "judge/build/job.hpp"
#include "judge/verdict/unit_result.hpp"

namespace tumble::judge {

std::string encode_result(const UnitResult& result);

/// @param job what was judged: its unit and file are not in the message
/// @throws std::exception if the message is not whole
UnitResult decode_result(const std::string& message, const Job& job);

}  // namespace tumble::judge
