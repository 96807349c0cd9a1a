#pragma once

namespace glissade::test {

/// Output of Google Benchmark 1.7, shortened.
inline constexpr const char* kCollisionBenchmarks = R"json({
  "context": {"date": "2026-11-21T12:00:00+00:00", "host_name": "secret", "num_cpus": 2, "caches": [],
    "library_build_type": "release", "machine": "2 cores (Test)",
                            "libraries" : "OMPL 1, FCL 2", "commit" : "abc123"
}
, "benchmarks" : [
  {
    "name" : "collide/L/near/fcl",
    "run_type" : "iteration",
    "iterations" : 10,
    "real_time" : 9e3,
    "cpu_time" : 8e3,
    "time_unit" : "ns"
  },
  {
    "name" : "collide/L/near/kernel",
    "run_type" : "iteration",
    "iterations" : 10,
    "real_time" : 2e2,
    "cpu_time" : 2e2,
    "time_unit" : "ns"
  },
  {
    "name" : "collide/pump/near/fcl",
    "run_type" : "iteration",
    "iterations" : 10,
    "real_time" : 9.0,
    "cpu_time" : 9.0,
    "time_unit" : "us"
  },
  {
    "name" : "collide/pump/near/kernel",
    "run_type" : "iteration",
    "iterations" : 10,
    "real_time" : 0.1,
    "cpu_time" : 0.1,
    "time_unit" : "us"
  },
  {
    "name" : "distance/L/near/fcl",
    "run_type" : "iteration",
    "iterations" : 10,
    "real_time" : 40.0,
    "cpu_time" : 40.0,
    "time_unit" : "us"
  },
  {
    "name" : "distance/L/near/kernel",
    "run_type" : "iteration",
    "iterations" : 10,
    "real_time" : 4.0,
    "cpu_time" : 4.0,
    "time_unit" : "us"
  },
  {
    "name" : "edge/L/near/kernel",
    "run_type" : "iteration",
    "iterations" : 10,
    "real_time" : 4.0,
    "cpu_time" : 4.0,
    "time_unit" : "us"
  }
]
})json";

inline constexpr const char* kGrowthBenchmarks = R"json({
  "context": {"date": "2026-11-21T12:05:00+00:00", "machine": "2 cores (Test)"
}
, "benchmarks" : [
  {
    "name" : "iteration/RRT/1000/iterations:1/manual_time",
    "run_type" : "iteration",
    "iterations" : 1,
    "real_time" : 10.0,
    "cpu_time" : 5e6,
    "time_unit" : "us",
    "size" : 1000
  },
  {
    "name" : "iteration/RRT/10000/iterations:1/manual_time",
    "run_type" : "iteration",
    "iterations" : 1,
    "real_time" : 100.0,
    "cpu_time" : 5e6,
    "time_unit" : "us",
    "size" : 10000
  },
  {
    "name" : "collide/kernel/100",
    "run_type" : "iteration",
    "iterations" : 9,
    "real_time" : 3.0,
    "cpu_time" : 2.0,
    "time_unit" : "us",
    "size" : 128
  },
  {
    "name" : "collide/kernel/1000",
    "run_type" : "iteration",
    "iterations" : 9,
    "error_occurred" : true,
    "error_message" : "out of memory"
  },
  {
    "name" : "collide/kernel/100_mean",
    "run_type" : "aggregate",
    "iterations" : 9,
    "real_time" : 3.0,
    "cpu_time" : 2.0,
    "time_unit" : "us"
  }
]
})json";

}  // namespace glissade::test
