"""Half width of a 95 % interval in standard errors."""
NORMAL = 1.959964   # of very many samples


def reach_95(degrees_of_freedom):
    """Quantile 0.975 of Student's t by its expansion about the normal (Abramowitz & Stegun 1964, 26.7.5): right to 2e-3 from 4 degrees on."""
    x, n = NORMAL, degrees_of_freedom
    return (x + (x**3 + x) / (4 * n) + (5 * x**5 + 16 * x**3 + 3 * x) / (96 * n**2) + (3 * x**7 + 19 * x**5 + 17 * x**3 - 15 * x) / (384 * n**3)
            + (79 * x**9 + 776 * x**7 + 1482 * x**5 - 1920 * x**3 - 945 * x) / (92160 * n**4))
