"""A Dask scheduler and two workers, each worker in a process, until somebody closes stdin."""

import sys

from distributed import LocalCluster


def main(preload: str) -> None:
    """Start the cluster and print its address."""
    with LocalCluster(
        n_workers=2,
        threads_per_worker=1,
        processes=True,
        dashboard_address=None,
        host="127.0.0.1",
        preload=preload,
        local_directory=None,
    ) as cluster:
        sys.stdout.write(f"{cluster.scheduler_address}\n")
        sys.stdout.flush()
        sys.stdin.read()


if __name__ == "__main__":
    main(sys.argv[1])
