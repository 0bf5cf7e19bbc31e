# motion.svg: trajectory, terms of the filter, and status over time.
# t, desired, real, error, p, i, d, output, pin HI, status
set table $d
plot 'trace.csv' every step using (column('t_s')):(column('desired_count')): \
  (column('theta_count')):(column('e')):(column('p')):(column('i')):(column('d')): \
  (column('output')):(column('host_irq')):(column('status')) with table
# A bit of one sample is seen though that sample is not drawn: also all samples where one changes.
before = -1
set table $s
plot 'trace.csv' using (now = column('host_irq') + 2 * (int(column('status')) / 2), \
  kept = now != before || int(column(0)) % step == 0, before = now, column('t_s')):(now) \
  with table if (kept)
unset table
set datafile separator whitespace
set datafile nocolumnheaders

set terminal svg size 900,1000 dynamic enhanced font 'Helvetica,13' background '#ffffff'
set output 'motion.svg'
set multiplot layout 4,1 title title
set lmargin 12
set rmargin 12
set xrange [from:to]
set ylabel 'position (counts)'
plot $d using 1:2 with lines lc rgb '#bbbbbb' lw 3 title 'desired', \
     $d using 1:3 with lines lc rgb '#d62728' lw 1.5 title 'real'
set ylabel 'error (counts)'
plot $d using 1:4 with lines lc rgb '#d62728' title ''
set ylabel 'filter'
plot $d using 1:8 with lines lc rgb '#bbbbbb' title 'output', \
     $d using 1:7 with lines lc rgb '#9467bd' title 'd', \
     $d using 1:5 with lines lc rgb '#1f77b4' lw 1.5 title 'p', \
     $d using 1:6 with lines lc rgb '#2ca02c' lw 1.5 title 'i'
set ylabel 'status'
set xlabel 'time (s)'
set yrange [-0.3:8]
set ytics ('HI' 0.35, 'error' 1.35, 'complete' 2.35, 'index' 3.35, 'wrap' 4.35, \
           'position' 5.35, 'breakpoint' 6.35, 'off' 7.35) font ',10'
plot for [k=0:7] $s using 1:(k + 0.7 * ((int($2) >> k) & 1)) with steps lc rgb '#444444' title ''
unset multiplot
